# SPDX-License-Identifier: Apache-2.0
"""The stub file has the names, arguments and defaults of the compiled module, and every name has a docstring."""
import ast
import inspect
import pathlib
import re
import unittest
from typing import Any

import jounce
import jounce._jounce as module

STUB = ast.parse((pathlib.Path(module.__file__).parent / "_jounce.pyi").read_text())
Argument = tuple[str, str]  # its name, with * before those after it; its default, or ""


def split(text: str) -> list[str]:
    """Arguments of a signature: commas inside brackets do not separate."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "[(<") - (c in "])>")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return [part.strip() for part in parts if part.strip()]


def of_module(name: str, function: Any, method: bool) -> list[list[Argument]]:
    """The signatures in the docstring of a function of pybind11, one for each overload."""
    found = []
    for line in (function.__doc__ or "").splitlines():
        if match := re.match(rf"\s*(?:\d+\. )?{re.escape(name)}\((.*)\) -> ", line):
            arguments = split(match[1])[1 if method else 0:]
            if not any(a.startswith("*args") for a in arguments):
                found.append([(a.split(":")[0], default_of(a)) for a in arguments])
    return found


def default_of(argument: str) -> str:
    """The default in a docstring, as in the stub."""
    default = argument.rpartition(" = ")[2] if " = " in argument else ""
    return default.replace("inf", "math.inf")


def of_stub(function: ast.FunctionDef) -> list[Argument]:
    a = function.args
    names = [x.arg for x in a.args]
    defaults = [""] * (len(names) - len(a.defaults)) + [ast.unparse(d) for d in a.defaults]
    found = [(n, d) for n, d in zip(names, defaults) if n != "self"]
    if a.kwonlyargs:
        found.append(("*", ""))
    return found + [(x.arg, "" if d is None else ast.unparse(d)) for x, d in zip(a.kwonlyargs, a.kw_defaults)]


class Stub(unittest.TestCase):
    def compare(self, name: str, function: Any, stubs: list[ast.FunctionDef], method: bool) -> None:
        runtime = of_module(name, function, method)
        unnamed = re.compile(r"arg\d$")
        runtime = [[a for a in s if not unnamed.match(a[0])] for s in runtime]
        for stub in stubs:
            if stub.args.vararg:
                continue
            self.assertIn(of_stub(stub), runtime, f"{name}, line {stub.lineno} of the stub")
        self.assertTrue(stubs, f"{name} is not in the stub")

    def functions(self, body: list[ast.stmt], name: str) -> list[ast.FunctionDef]:
        return [node for node in body if isinstance(node, ast.FunctionDef) and node.name == name]

    def test_functions(self) -> None:
        for name, function in vars(module).items():
            if callable(function) and not inspect.isclass(function) and not name.startswith("_"):
                self.compare(name, function, self.functions(STUB.body, name), False)
                self.assertGreater(len(function.__doc__.splitlines()), 2, f"{name} has no docstring")

    def test_classes(self) -> None:
        classes = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
        runtime = {name: c for name, c in vars(module).items() if inspect.isclass(c)}
        self.assertEqual(set(classes), set(runtime))
        for name, c in runtime.items():
            self.assertTrue(c.__doc__, f"{name} has no docstring")
            names = {node.name for node in classes[name].body if isinstance(node, ast.FunctionDef)}
            for member, value in vars(c).items():
                if member.startswith("__") and member not in names:
                    continue
                self.assertIn(member, names, f"{name}.{member} is not in the stub")
                stubs = self.functions(classes[name].body, member)
                if isinstance(value, property):
                    self.assertEqual(ast.unparse(stubs[0].decorator_list[0]), "property")
                    self.assertTrue(value.__doc__, f"{name}.{member} has no docstring")
                else:
                    static = isinstance(value, staticmethod)
                    self.compare(member, value.__func__ if static else value, stubs, not static)
            self.assertEqual(names - set(dir(c)), set())

    def test_the_package_exports_all_of_it(self) -> None:
        for name in vars(module):
            if not name.startswith("_"):
                self.assertIs(getattr(jounce, name), getattr(module, name))
                self.assertIn(name, jounce.__all__)
        for name in jounce.__all__:
            if name != "__version__":
                self.assertEqual(getattr(jounce, name).__module__, "jounce", name)


if __name__ == "__main__":
    unittest.main()
