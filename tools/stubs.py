"""Writes the stubs: the functions that the program calls in place of OpenGL's."""
from __future__ import annotations

import glxml
import vertex_calls
from policy import Policy, PolicyError

SHARDS = 16
RUN = "case Gate::compile: case Gate::run: break;"


def _signature(c: glxml.Command) -> str:
    return f"{c.ret} APIENTRY stub{c.short}({c.declaration})"


def _call(c: glxml.Command, context: str, arguments: dict[str, str] | None = None) -> tuple[str, str]:
    """The handler's and the real command's call on `context` (a C++ expression of type Context&)."""
    passed = [(arguments or {}).get(p.name, p.name) for p in c.params]
    handler = c.short[0].lower() + c.short[1:]
    real = "ctx->real" if context == "*ctx" else f"{context}.real"
    return f"gl::{handler}({', '.join([context, *passed])})", f"{real}.{c.short}({', '.join(passed)})"


def _copies(c: glxml.Command, policy: Policy) -> tuple[list[str], dict[str, str]]:
    """Captures that own what the command's pointers point at, and the expressions that read them back."""
    captures, replace = ["="], {}
    for p in c.params:
        if not p.pointer:
            continue
        length = policy.copy.get(p.name, p.length)
        if length is None or "COMPSIZE" in length or p.type.count("*") > 1 or "const" not in p.type:
            raise PolicyError(f"{c.name}: the registry does not say how much '{p.type} {p.name}' points at; "
                              f'add copy = {{ {p.name} = "..." }} or list = "immediate" to its row')
        captures.append(f"{p.name}Copy = copyOf({p.name}, {length})")
        replace[p.name] = f"{p.name}Copy.get()"
    return captures, replace


def _no_context(c: glxml.Command) -> str:
    """Without a GLuRay context the call belongs to a context that GLuRay never saw (or to none)."""
    call = f"orphan->{c.short}({c.arguments})"
    if c.ret == "void":
        return f"  if (!ctx) [[unlikely]] {{\n    if (const RealGl* orphan = orphanGl()) {call};\n    return;\n  }}\n"
    return (f"  if (!ctx) [[unlikely]] {{\n    const RealGl* orphan = orphanGl();\n"
            f"    return orphan ? {call} : static_cast<{c.ret}>(0);\n  }}\n")


def _gate(c: glxml.Command, policy: Policy, compile_case: str) -> str:
    returns = "return " if c.ret != "void" else ""
    done = "" if returns else " return;"
    nothing = "return {};" if returns else "return;"
    _, real = _call(c, "*ctx")
    how = f'"{c.name}"' + (", true" if policy.begin else ", false, false" if policy.immediate else "")
    return (f"  if (ctx->attention) [[unlikely]] {{\n"
            f"    switch (ctx->gate({how})) {{\n"
            f"      case Gate::forward: {returns}{real};{done}\n"
            f"      case Gate::refuse: {nothing}\n"
            f"      {compile_case}\n    }}\n  }}\n")


def _effect(policy: Policy, handler: str, context: str) -> str:
    """The effect of a tracked command on the shadow state: its handler's call, the groups it touches, or both."""
    pointer = context == "*ctx"
    groups = policy.touch.replace("{c}", context)
    touch = f"{'ctx->' if pointer else 'later.'}touch({groups});" if groups else ""
    call = f"ctx->protect([&] {{ {handler}; }});" if pointer else f"{handler};"
    return " ".join(filter(None, [call if policy.handler else "", touch]))


def _before(policy: Policy) -> str:
    """The call that prepares for a forwarded command."""
    if policy.flush == "leave":
        return "beforeForward(flushToBind(*ctx, target, framebuffer));"
    if policy.flush == "read":
        return "beforeForward(flushToRead(format));"
    how = {False: "none", True: "all", "redirect": "redirect", "look": "look"}[policy.flush]
    return f"beforeForward(Context::Flush::{how});"


def _stores(policy: Policy, context: str) -> str:
    """The call that notes that the command makes the real OpenGL store current values."""
    return f" {context}storesCurrent();" if policy.sync else ""


def _track(c: glxml.Command, policy: Policy) -> str:
    handler, real = _call(c, "*ctx")
    if policy.immediate:
        compile_case = RUN
    else:
        captures, replace = _copies(c, policy)
        late_handler, late_real = _call(c, "later", replace)
        late_before = f"later.{_before(policy)} " if policy.flush else ""
        fragment = (f"if ({policy.fragment}) return ctx->lists.recordFragment([&] {{ {real}; }});\n        "
                    if policy.fragment else "")
        compile_case = (f"case Gate::compile: {fragment}ctx->lists.record([{', '.join(captures)}](Context& later) "
                        f"{{ {late_before}{_effect(policy, late_handler, 'later')}{_stores(policy, 'later.')} {late_real}; }}); return;\n      case Gate::run: break;")
    before = f"ctx->{_before(policy)} " if policy.flush else ""
    effect = _effect(policy, handler, '*ctx') + _stores(policy, 'ctx->')
    return (_gate(c, policy, compile_case) + f"  {before}{effect}\n"
            f"  {'return ' if c.ret != 'void' else ''}{real};\n")


def _own(c: glxml.Command, policy: Policy) -> str:
    handler, _ = _call(c, "*ctx")
    return (_gate(c, policy, RUN) +
            f"  {'return ' if c.ret != 'void' else ''}ctx->protect([&] {{ return {handler}; }});\n")


def _forward(c: glxml.Command, policy: Policy, index: int) -> str:
    _, real = _call(c, "*ctx")
    images = any(call in policy.touch for call in ("imageChanged(", "imagesChanged(", "imageCopied("))
    later = " ctx->lists.record([](Context& later) { later.touch(imagesChanged(later)); });" if images else ""
    compile_case = RUN if policy.immediate else (
        f"case Gate::compile: ctx->lists.recordFragment([&] {{ {real}; }});{later} return;\n      case Gate::run: break;")
    # Afterwards once more: another context that reads an image or a buffer again must find it changed.
    touch = f"  ctx->touch({policy.touch.replace('{c}', '*ctx')});\n" if policy.touch else ""
    scope = f"  {policy.scope.replace('{c}', '*ctx')}\n" if policy.scope else ""
    return (_gate(c, policy, compile_case) + f"  ctx->count({index});\n"
            f"  ctx->{_before(policy)}\n{scope}" +
            (f"{touch}  return {real};\n" if c.ret != "void" else
             f"{touch}  {real};\n{touch if '{c}' in policy.touch else ''}"))


def stub(c: glxml.Command, policy: Policy, index: int) -> str:
    if policy.kind == "attribute":
        count = "++t_thread.passthroughVertices, " if c.short.startswith("Vertex") and not c.short.startswith("VertexA") else ""
        return (f"{_signature(c)} {{\n  if (!t_thread.stream) [[unlikely]] {{\n"
                f"    if (const RealGl* below = t_thread.passthrough) {{\n      {count}below->{c.short}({c.arguments});\n"
                f"      return;\n    }}\n    if (!t_thread.context) {{\n"
                f"      if (const RealGl* orphan = orphanGl()) orphan->{c.short}({c.arguments});\n      return;\n    }}\n"
                f"  }}\n  {vertex_calls.body(c)}\n}}\n")
    body = {"track": _track, "own": _own}.get(policy.kind)
    text = body(c, policy) if body else _forward(c, policy, index)
    return f"{_signature(c)} {{\n  Context* ctx = t_thread.context;\n{_no_context(c)}{text}}}\n"


def shards(commands: list[glxml.Command], table: dict[str, Policy], canonical: dict[str, str]) -> list[str]:
    """The text of each stub file. Commands served by another command's stub have none of their own."""
    files: list[list[str]] = [[] for _ in range(SHARDS)]
    index = {c.name: i for i, c in enumerate(commands)}
    own = [c for c in commands if canonical[c.name] == c.name]
    for i, c in enumerate(own):
        files[i * SHARDS // len(own)].append(stub(c, table[c.name], index[c.name]))
    head = '#include "intercept/stubs/stub_support.h"\n\nnamespace gluray::intercept::stubs {\n\nusing namespace gl;\n\n'
    return [head + "\n".join(texts) + "\n}  // namespace gluray::intercept::stubs\n" for texts in files]


def lookup(commands: list[glxml.Command], canonical: dict[str, str]) -> str:
    """The name table, sorted for binary search."""
    by_name = {c.name: c for c in commands}
    declarations = "\n".join(f"{_signature(c)};" for c in commands if canonical[c.name] == c.name)
    rows = "\n".join(f'    {{"{name}", reinterpret_cast<void*>(&stubs::stub{by_name[canonical[name]].short})}},'
                     for name in sorted(by_name))
    return f"""#include <algorithm>
#include <cstring>
#include <iterator>

#include <GL/gl.h>
#include <GL/glext.h>

#include "intercept/stubs/stub_proc.h"

namespace gluray::intercept {{
namespace stubs {{
{declarations}
}}  // namespace stubs

namespace {{
struct Row {{
  const char* name;
  void* function;
}};
const Row kRows[] = {{
{rows}
}};
}}  // namespace

void* stubProc(const char* name) {{
  const auto* row = std::lower_bound(std::begin(kRows), std::end(kRows), name,
                                     [](const Row& r, const char* n) {{ return std::strcmp(r.name, n) < 0; }});
  return row != std::end(kRows) && std::strcmp(row->name, name) == 0 ? row->function : nullptr;
}}

}}  // namespace gluray::intercept
"""
