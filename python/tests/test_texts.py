"""What documents the package: docstrings, stubs, the guide and the notebook."""

import ast
import contextlib
import doctest
import email
import inspect
import io
import json
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

import feltline

PACKAGE = Path(feltline.__file__).parent
SOURCE = Path(__file__).resolve().parents[2]
CLASSES = [c for c in vars(feltline).values() if inspect.isclass(c)]


def documented():
    """Yields (name, object) for the public functions, classes, methods and properties."""
    yield "feltline", feltline
    yield "feltline.trial", feltline.trial
    for module in (feltline, feltline.trial):
        for name in module.__all__:
            thing = getattr(module, name)
            if not inspect.ismodule(thing):
                yield f"{module.__name__}.{name}", thing
    for cls in CLASSES:
        if not issubclass(cls, (tuple, Exception)):
            for name, thing in vars(cls).items():
                if not name.startswith("_"):
                    yield f"feltline.{cls.__name__}.{name}", thing


def run_examples(name, text):
    """Runs the examples of a text and returns their number. Fails if one fails."""
    test = doctest.DocTestParser().get_doctest(text, {"feltline": feltline}, name, name, 0)
    report = io.StringIO()
    with contextlib.redirect_stdout(report):
        result = doctest.DocTestRunner().run(test)
    if result.failed:
        raise AssertionError(report.getvalue())
    return result.attempted


def signature_of(thing):
    """Returns (name, is_keyword_only, default) of each parameter, of functions in Python and C++."""
    if inspect.isfunction(thing):
        parameters = inspect.signature(thing).parameters.values()
        return [(p.name, p.kind == p.KEYWORD_ONLY, p.default if p.default is not p.empty else ...)
                for p in parameters]
    text = re.search(r"\((.*)\)( -> .*)?$", thing.__doc__.splitlines()[0]).group(1)
    while "[" in text:
        text = re.sub(r"\[[^\[\]]*\]", "", text)  # the arguments of types
    text = re.sub(r": [^,=]*?(?= =|,|$)", "", text)
    return arguments_of(ast.parse(f"def f({text}): ...").body[0])


def arguments_of(function):
    arguments = function.args
    defaults = [None] * (len(arguments.args) - len(arguments.defaults)) + arguments.defaults
    both = [(a, False, d) for a, d in zip(arguments.args, defaults)]
    both += [(a, True, d) for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return [(a.arg, only, ast.literal_eval(d) if d is not None else ...) for a, only, d in both]


class Texts(unittest.TestCase):
    def test_everything_is_documented_and_the_examples_are_right(self):
        examples = 0
        for name, thing in documented():
            text = inspect.getdoc(thing) or ""
            if inspect.isroutine(thing) and not inspect.isfunction(thing):
                text = text.partition("\n")[2]  # the signature
            with self.subTest(name):
                self.assertGreater(len(text.strip()), 20, f"{name} has no docstring")
                examples += run_examples(name, text)
        self.assertGreater(examples, 25)

    @unittest.skipUnless((SOURCE / "docs/guide").is_dir(), "not in the sdist")
    def test_the_examples_of_the_guide_are_right(self):
        text = (SOURCE / "docs/guide/python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                self.assertGreater(run_examples("python.md", "\n".join(blocks)), 10)
            finally:
                os.chdir(before)

    def test_the_notebook_runs(self):
        path = SOURCE / "python/examples/fit.ipynb"
        notebook = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual(notebook["nbformat"], 4)
        names = {"__name__": "__main__"}
        before = os.getcwd()
        os.chdir(path.parent)
        try:
            cells = [c for c in notebook["cells"] if c["cell_type"] == "code"]
            for cell in cells:
                self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None))
                with contextlib.redirect_stdout(io.StringIO()):
                    exec(compile("".join(cell["source"]), str(path), "exec"), names)
        finally:
            os.chdir(before)
        self.assertGreater(len(cells), 3)


class Metadata(unittest.TestCase):
    @unittest.skipIf(sys.version_info < (3, 11), "needs tomllib")
    def test_is_that_of_pyproject(self):
        import tomllib
        sys.path.insert(0, str(SOURCE / "python"))
        import feltline_build
        project = tomllib.loads((SOURCE / "pyproject.toml").read_text("utf-8"))["project"]
        metadata = email.message_from_string(feltline_build._metadata())
        self.assertEqual(metadata["Name"], project["name"])
        self.assertEqual(metadata["Version"], feltline.__version__)
        self.assertEqual(metadata["Summary"], project["description"])
        self.assertEqual(metadata["License"], project["license"]["text"])
        self.assertEqual(metadata["Requires-Python"], project["requires-python"])
        extras = [f"{package}; extra == '{extra}'"
                  for extra, packages in project["optional-dependencies"].items()
                  for package in packages]
        self.assertEqual(metadata.get_all("Requires-Dist"), project["dependencies"] + extras)
        self.assertEqual(metadata.get_payload(),
                         (SOURCE / project["readme"]).read_text("utf-8"))


class Stubs(unittest.TestCase):
    def check_function(self, where, declared, thing):
        self.assertEqual(arguments_of(declared), signature_of(thing), where)

    def check_class(self, declared, cls):
        members = {node.name: node for node in declared.body if isinstance(node, ast.FunctionDef)}
        public = {name for name in vars(cls) if not name.startswith("_")}
        if issubclass(cls, (tuple, Exception)):  # these have no functions
            fields = [n.target.id for n in declared.body if isinstance(n, ast.AnnAssign)]
            self.assertEqual(fields, list(getattr(cls, "_fields", fields)), cls.__name__)
            return
        self.assertEqual({n for n in members if not n.startswith("_")}, public, cls.__name__)
        for name, node in members.items():
            where = f"{cls.__name__}.{name}"
            self.assertTrue(hasattr(cls, name), where)
            is_property = any(getattr(d, "id", "") == "property" for d in node.decorator_list)
            self.assertEqual(is_property, isinstance(vars(cls).get(name), property), where)
            if not is_property and (not name.startswith("_") or name == "__init__"):
                self.check_function(where, node, getattr(cls, name))

    def test_have_the_names_and_signatures_of_the_package(self):
        for module, file in ((feltline, "__init__.pyi"), (feltline.trial, "trial.pyi")):
            tree = ast.parse((PACKAGE / file).read_text(encoding="utf-8"))
            nodes = {n.name: n for n in tree.body if isinstance(n, (ast.FunctionDef, ast.ClassDef))}
            self.assertEqual(set(nodes) | ({"trial"} if module is feltline else set()),
                             set(module.__all__))
            for name, node in nodes.items():
                thing = getattr(module, name)
                if isinstance(node, ast.ClassDef):
                    self.check_class(node, thing)
                else:
                    self.check_function(name, node, thing)
        self.assertTrue((PACKAGE / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
