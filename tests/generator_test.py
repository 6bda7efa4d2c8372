"""Unit tests of the generator: generator_test.py"""
from __future__ import annotations

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools"))

import c_headers  # noqa: E402
import doors  # noqa: E402
import glxml  # noqa: E402
import vertex_calls  # noqa: E402
import policy  # noqa: E402
import stubs  # noqa: E402

COMMANDS = glxml.desktop_gl()
BY_NAME = {c.name: c for c in COMMANDS}


def table(*rows: dict) -> dict[str, policy.Policy]:
    return policy.policies(COMMANDS, list(rows))


def stub(name: str, *rows: dict) -> str:
    return stubs.stub(BY_NAME[name], table(*rows)[name], 7)


class Leaf(unittest.TestCase):
    def check(self, name: str, body: str):
        self.assertEqual(vertex_calls.body(BY_NAME[name]), body)

    def test_missing_components(self):
        self.check("glVertex2f", "vertexcall::vertex(x, y, 0.0f, 1.0f);")
        self.check("glTexCoord1f", "vertexcall::texCoord(0u, s, 0.0f, 0.0f, 1.0f);")
        self.check("glColor3f", "vertexcall::color(red, green, blue, 1.0f);")
        self.check("glVertexAttrib1f", "vertexcall::vertexAttrib(index, x, 0.0f, 0.0f, 1.0f);")

    def test_vectors(self):
        self.check("glNormal3fv", "vertexcall::normal(v[0], v[1], v[2]);")
        self.check("glVertex4fv", "vertexcall::vertex(v[0], v[1], v[2], v[3]);")

    def test_integers_are_normalised_where_table_2_9_says(self):
        self.check("glColor4ubv", "vertexcall::color(normalised(v[0]), normalised(v[1]), normalised(v[2]), normalised(v[3]));")
        self.check("glNormal3b", "vertexcall::normal(normalised(nx), normalised(ny), normalised(nz));")
        self.check("glSecondaryColor3us", "vertexcall::secondaryColor(normalised(red), normalised(green), normalised(blue));")
        self.check("glVertexAttrib4Nsv",
                   "vertexcall::vertexAttrib(index, normalised(v[0]), normalised(v[1]), normalised(v[2]), normalised(v[3]));")

    def test_integers_are_plain_elsewhere(self):
        self.check("glVertex2i", "vertexcall::vertex(static_cast<GLfloat>(x), static_cast<GLfloat>(y), 0.0f, 1.0f);")
        self.check("glVertexAttrib1s", "vertexcall::vertexAttrib(index, static_cast<GLfloat>(x), 0.0f, 0.0f, 1.0f);")
        self.check("glIndexub", "vertexcall::index(static_cast<GLfloat>(c));")
        self.check("glFogCoordd", "vertexcall::fogCoord(static_cast<GLfloat>(coord));")

    def test_units_count_from_zero(self):
        self.check("glMultiTexCoord2f", "vertexcall::texCoord(target - GL_TEXTURE0, s, t, 0.0f, 1.0f);")

    def test_other_commands_are_refused(self):
        for name in ("glVertexPointer", "glVertexAttribI4i", "glTexCoord2fVertex3fSUN", "glNormalPointer"):
            with self.assertRaises(ValueError):
                vertex_calls.body(BY_NAME[name])


class Policy(unittest.TestCase):
    def test_unnamed_commands_are_forwarded_and_flush(self):
        row = table()["glDrawPixels"]
        self.assertEqual((row.kind, row.flush, row.coverage), ("forward", True, "forwarded"))

    def test_later_rows_override_single_fields(self):
        row = table({"commands": ["glLight*"], "class": "track", "flush": True}, {"commands": ["glLightf"], "flush": False})
        self.assertEqual((row["glLightf"].kind, row["glLightf"].flush, row["glLighti"].flush), ("track", False, True))

    def test_except(self):
        rows = table({"commands": ["glGet*"], "except": ["glGetTexImage"], "flush": False})
        self.assertEqual((rows["glGetString"].flush, rows["glGetTexImage"].flush), (False, True))

    def test_misspelt_command_is_an_error(self):
        with self.assertRaisesRegex(policy.PolicyError, "glShadeModle"):
            table({"commands": ["glShadeModle"]})

    def test_aliases_follow_modelled_commands_only(self):
        rows = table({"commands": ["glActiveTexture"], "class": "track"})
        served = policy.canonical(COMMANDS, rows)
        self.assertEqual(served["glActiveTextureARB"], "glActiveTexture")
        self.assertEqual(served["glCompressedTexImage2DARB"], "glCompressedTexImage2DARB")

    def test_values_cannot_be_compiled_into_lists(self):
        self.assertTrue(table()["glIsTexture"].immediate)


class Stubs(unittest.TestCase):
    def test_forward_counts_and_keeps_order(self):
        text = stub("glDrawPixels")
        self.assertLess(text.index("count(7)"), text.index("beforeForward(Context::Flush::all)"))
        self.assertLess(text.index("beforeForward(Context::Flush::all)"), text.rindex("real.DrawPixels("))
        self.assertIn("recordFragment", text)

    def test_immediate_commands_are_not_compiled(self):
        text = stub("glPixelStorei", {"commands": ["glPixelStorei"], "list": "immediate"})
        self.assertNotIn("record", text)

    def test_track_copies_what_pointers_point_at(self):
        text = stub("glMultMatrixf", {"commands": ["glMultMatrixf"], "class": "track"})
        self.assertIn("mCopy = copyOf(m, 16)", text)
        self.assertIn("gl::multMatrixf(later, mCopy.get())", text)

    def test_track_needs_to_know_how_much_to_copy(self):
        with self.assertRaisesRegex(policy.PolicyError, "glLightfv.*params"):
            stub("glLightfv", {"commands": ["glLightfv"], "class": "track"})
        text = stub("glLightfv", {"commands": ["glLightfv"], "class": "track", "copy": {"params": "lightParams(pname)"}})
        self.assertIn("copyOf(params, lightParams(pname))", text)

    def test_every_command_has_a_stub(self):
        rows = policy.policies(COMMANDS, policy.read_rows())
        served = policy.canonical(COMMANDS, rows)
        text = "".join(stubs.shards(COMMANDS, rows, served))
        for command in COMMANDS:
            self.assertIn(f"stub{BY_NAME[served[command.name]].short}(", text)


class Registries(unittest.TestCase):
    def test_every_type_is_known_to_the_doors(self):
        for command in [*COMMANDS, *glxml.load("glx", ("glx",)), *c_headers.egl(), *c_headers.osmesa()]:
            for kind in [command.ret, *(p.type for p in command.params)]:
                if kind not in doors.UNKNOWN_TO_ANY_HEADER:
                    doors._c_type(kind)

    def test_headers_are_read_whole(self):
        egl, osmesa = {c.name for c in c_headers.egl()}, {c.name for c in c_headers.osmesa()}
        self.assertGreater(len(egl), 44 + 60)
        self.assertLessEqual({"eglCreateContext", "eglGetPlatformDisplay", "eglSwapBuffersWithDamageKHR"}, egl)
        self.assertLessEqual({"OSMesaCreateContextAttribs", "OSMesaGetColorBuffer", "OSMesaPostprocess"}, osmesa)


if __name__ == "__main__":
    unittest.main()
