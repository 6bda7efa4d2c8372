"""For Spack: copy it to packages/gluray/package.py of a repository."""
from spack.package import *


class Gluray(CMakePackage):
    """Ray traces what unmodified OpenGL programs draw, on the CPU: gluray PROGRAM."""

    homepage = "https://example.org/gluray"
    url = "https://example.org/gluray-0.1.0.tar.xz"  # the archive of scripts/package source

    license("Apache-2.0")
    version("0.1.0", sha256="0" * 64)

    variant("panel", default=False, description="gluray-panel, a window with Qt 6")
    variant("mpi", default=True, description="jobs of gluray-worker with many ranks")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("python@3.11:", type=("build", "run"))
    for library in ("embree@3.13:", "intel-oneapi-tbb", "highway@1:", "glm", "spdlog", "cli11", "tomlplusplus", "nlohmann-json", "asio",
                    "libsodium", "libpng", "openexr@3:", "xxhash", "zlib-api", "libglvnd", "libx11", "libxext", "libxcb"):
        depends_on(library)
    depends_on("gl")
    depends_on("mpi", when="+mpi")
    depends_on("qt-base@6.2:", when="+panel")

    conflicts("%gcc@:10", msg="GLuRay is written in C++20")
    requires("platform=linux")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("GLURAY_TESTS", False),
            self.define("GLURAY_BENCH", False),
            self.define("GLURAY_UNITY", True),
            self.define("CMAKE_DISABLE_FIND_PACKAGE_Qt6", self.spec.satisfies("~panel")),
        ]

    def setup_run_environment(self, env):
        env.prepend_path("PYTHONPATH", join_path(self.prefix, "lib", "python3", "dist-packages"))
