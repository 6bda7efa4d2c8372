"""Per-vertex attribute commands: what a name like glMultiTexCoord3sv means.

Conversions follow GL 2.1, table 2.9: Color, SecondaryColor, Normal and VertexAttrib4N map integers to [-1, 1] or
[0, 1]; positions, texture coordinates and plain attributes take integers as they are.
"""
from __future__ import annotations

import re

import glxml

# Name stem -> (function of gl::vertexcall, components the function takes, normalised)
KINDS = {
    "Vertex": ("vertex", 4, False),
    "Normal": ("normal", 3, True),
    "Color": ("color", 4, True),
    "TexCoord": ("texCoord", 4, False),
    "MultiTexCoord": ("texCoord", 4, False),
    "SecondaryColor": ("secondaryColor", 3, True),
    "FogCoord": ("fogCoord", 1, False),
    "Index": ("index", 1, False),
    "VertexAttrib": ("vertexAttrib", 4, False),
    "VertexAttribN": ("vertexAttrib", 4, True),
}
SUFFIX = r"(?:ARB|EXT|NV)?$"
PLAIN = re.compile(r"^gl(Vertex|Normal|Color|TexCoord|MultiTexCoord|SecondaryColor|VertexAttrib)([1234])(N?)"
                   r"(b|s|i|f|d|h|ub|us|ui)(v?)" + SUFFIX)
SINGLE = re.compile(r"^gl(FogCoord|Index)(ub|s|i|f|d|h)(v?)" + SUFFIX)
PACKED = re.compile(r"^gl(Vertex|Normal|Color|TexCoord|MultiTexCoord|SecondaryColor|VertexAttrib)P([1234])ui(v?)$")


def _fill(values: list[str], wanted: int) -> str:
    """Missing components are 0, a missing fourth one 1."""
    defaults = ["0.0f", "0.0f", "0.0f", "1.0f"]
    return ", ".join(values + defaults[len(values):wanted])


def _leading(stem: str, names: list[str]) -> list[str]:
    """The argument before the components: texture unit or attribute index."""
    if stem == "MultiTexCoord":
        return [f"{names[0]} - GL_TEXTURE0"]
    if stem.startswith("VertexAttrib"):
        return [names[0]]
    if stem == "TexCoord":
        return ["0u"]
    return []


def body(command: glxml.Command) -> str:
    """The statements of the stub, without braces. Raises ValueError if the name is not an attribute command."""
    names = [p.name for p in command.params]
    if command.name in ("glEdgeFlag", "glEdgeFlagv"):
        return f"vertexcall::edgeFlag({'*' if command.name.endswith('v') else ''}{names[0]} != GL_FALSE);"
    if match := PLAIN.match(command.name):
        stem, count, normal, letter, vector = match.groups()
        stem += normal
        count = int(count)
    elif match := SINGLE.match(command.name):
        stem, letter, vector = match.groups()
        count = 1
    elif match := PACKED.match(command.name):
        return _packed(command, *match.groups())
    else:
        raise ValueError(f"{command.name} is not a per-vertex attribute command that the generator knows")
    function, wanted, normalised = KINDS[stem]
    lead = _leading(stem, names)
    values = [f"{names[-1]}[{i}]" for i in range(count)] if vector else names[-count:]
    if letter == "h":
        values = [f"halfToFloat({v})" for v in values]
    elif normalised and letter not in "fd":
        values = [f"normalised({v})" for v in values]
    elif letter != "f":
        values = [f"static_cast<GLfloat>({v})" for v in values]
    return f"vertexcall::{function}({', '.join(lead + [_fill(values, wanted)])});"


def _packed(command: glxml.Command, stem: str, count: str, vector: str) -> str:
    """Forms packed into 32 bits. An unknown type is left to the real OpenGL, which records the error."""
    names = [p.name for p in command.params]
    type_name = next(p.name for p in command.params if p.type == "GLenum" and p.name != "texture")
    function, wanted, normalised = KINDS[stem]
    unpack = "unpackGeneric3" if stem == "VertexAttrib" and count == "3" else "unpack"
    scale = "normalized != GL_FALSE" if stem == "VertexAttrib" else str(normalised).lower()
    value = f"{'*' if vector else ''}{names[-1]}"
    parts = [f"v.{part}" for part in "xyzw"[:int(count)]]
    call = f"vertexcall::{function}({', '.join(_leading(stem, names) + [_fill(parts, wanted)])});"
    return (f"Packed v;\n  if ({unpack}(packedRulesOfNow(), {type_name}, {scale}, {value}, v)) {call}\n"
            f"  else if (t_thread.context) t_thread.context->real.{command.short}({command.arguments});")
