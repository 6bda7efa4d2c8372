#!/usr/bin/env python3
"""tools/known_code.py: which statements of captured programs a file of known code lacks, with placeholders and slots."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools/known_code.py"
CODE = """
[[code]]
name = "c"
statements = '''
uniform float u;
float k = max(x, $floor);
vec4 cast() { @blend.start while (true) { @crop take(); @blend.sample } @blend.end return c; }
@blend.global;
'''
[[code.fragments]]
slot = "blend"
word = "maximum"
global = "vec4 m"
start = "m = vec4(0.0);"
sample = '''
if (m < s) { m = s; } // keeps the largest
'''
end = "c = m;"
[[code.fragments]]
slot = "blend"
word = "maximum"
sample = "m = max(m, s);"
[[code.fragments]]
slot = "blend"
word = "sum"
sample = "c += $weight * s;"
[[code.fragments]]
slot = "crop"
word = "box"
text = "if (@side < low) skip();"
[[code.fragments]]
slot = "side"
word = "left"
required = true
text = 'p.x'
"""


def cast(start="", crop="", sample="", end=""):
    return f"vec4 cast() {{ {start} while (true) {{ {crop} take(); {sample} }} {end} return c; }}\n"


class KnownCode(unittest.TestCase):
    def differences(self, *shaders):
        with tempfile.TemporaryDirectory() as folder:
            code = pathlib.Path(folder, "code.toml")
            code.write_text(CODE)
            for i, text in enumerate(shaders):
                pathlib.Path(folder, f"{i}.shader_test").write_text(f"[require]\nGLSL >= 1.50\n[fragment shader]\n{text}")
            run = subprocess.run([sys.executable, TOOL, "--code", code, folder], capture_output=True, text=True, check=True)
        return [line.split(maxsplit=1) for line in run.stdout.splitlines()]

    def test_known(self):
        maximum = dict(start="m = vec4(0.);", end="c = m;")
        for text in ["float k = max(x, 1e-8);", cast(), cast(sample="c += 0.5f * s;"), "vec4 m;" + cast(sample="m = max(m,s);", **maximum),
                     cast(sample="if (m < s) { m = s; }", **maximum), cast(crop="if (p.x < low) skip();", sample="c += 2.0 * s;")]:
            self.assertEqual(self.differences(text), [], text)

    def test_unknown(self):
        for text in ["float k=max(x,y);", cast(crop="if (p.y < low) skip();"), cast(start="c = m;"), cast(sample="c += s;"), "float m;",
                     "vec4 mm;"]:
            self.assertEqual(len(self.differences(text)), 1, text)
        self.assertEqual(self.differences("float k = max(x, y);", "float k=max(x, y); float z;"),
                         [["2", "float k=max(x,y);"], ["1", "float z;"]])

    def test_mixed(self):
        mixed = ["1", 'no word whose fragments stand in all slots "@blend"']
        self.assertEqual(self.differences(cast(crop="if ( < low) skip();")), [["1", 'no word whose fragments stand in all slots "@side"']])
        for text in [cast(start="m = vec4(0.);", sample="c += 2.0 * s;"), cast(sample="c += 2.0 * s;") + "vec4 m;",
                     cast(start="m = vec4(0.);", sample="m = max(m, s);")]:
            self.assertEqual(self.differences(text), [mixed], text)


if __name__ == "__main__":
    unittest.main()
