"""A Java program whose native library links libGL, as Java 3D's does: java_test.py GLURAY DOOR LIBRARY. Exit code 77: no Java."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

GLURAY, DOOR, LIBRARY = sys.argv[1:4]
SOURCE = """public class Door {
  static native int draw();
  public static void main(String[] words) {
    System.load(words[0]);
    System.exit(draw());
  }
}
"""


def main() -> int:
    if not shutil.which("java") or not shutil.which("javac"):
        print("no Java development kit is installed")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "Door.java")
        source.write_text(SOURCE)
        if subprocess.run(["javac", source]).returncode != 0:
            print("the Java compiler does not work")
            return 77
        check = pathlib.Path(__file__).with_name("check.py")
        return subprocess.run([sys.executable, check, "--gluray", GLURAY, "--door", DOOR, "--", "java", "-Xmx64m", "-cp", folder, "Door",
                               LIBRARY]).returncode


if __name__ == "__main__":
    sys.exit(main())
