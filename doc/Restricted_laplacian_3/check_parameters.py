#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what the manual says of named parameters against the code: check_parameters.py --root FOLDER [--update]

The names in named_parameters.doxy are those of foundation/internal/parameters.h, each of them is shown with
a function and on the page of named parameters, and the defaults are those of the code. What Python
says of its arguments, and takes for them, is the same. Arguments of Python and options of programs have the
names of C++, or are among those that C++ does not have; the page of named parameters has the table of them,
which --update writes.
"""

import argparse
import ast
import pathlib
import re

HEADERS = "include/CGAL/Restricted_laplacian_3"
# Constants that the code takes as defaults, and the group of rows whose text has to name the value.
CONSTANTS = (
    ("problems/Poisson_problem.h", "tolerance_with_constraints", "of_poisson"),
    ("problems/integrate_gradients.h", "default_gradient_tolerance", "of_gradients"),
    ("problems/integrate_gradients.h", "default_gradient_tolerance", "of_stitching"),
    ("problems/stabilization.h", "default_curvature_stabilization", "of_curvature"),
    ("problems/Function_fitter.h", "default_tolerance", "of_fits"),
    ("problems/Function_fitter.h", "default_tolerance", "of_curvature"),
)
# What has a default in Python, or an option in a program, and is no named parameter of C++: data, places
# and files; what is returned and shown; and numbers that C++ takes as arguments. `threads` is the
# `concurrency_tag` of CGAL, which is a type.
PYTHON_ONLY = """F anisotropy areas as_spline barycentric boundary cache check colors count data descriptors
    energies exact f faces factor first fwhm gradient_scale guess height isolines k_eig labels landmarks
    laplacian_weight length level lines longest_side mask name names normalization normals number op_cache_dir
    orthonormal out overwrite_cache patterns per_parcel points positions processes range refine report
    return_report scaled scans segments sigma signal sources stabilize_mass start step steps subdivisions target_points
    targets threads time time_step times title u0 up v values vertex_normals""".split()
PROGRAMS_ONLY = """anisotropy assembly beside boundary boundary-property clip column columns compare count csv
    density-property descriptor diffusion-property eigenfunction energy exact exposure-range exposures factor
    farthest field-of-view flux-property frame fwhm gradient-scale gradient-scale-property help html isolines
    leave-out length light lines no-legend noise normalization normals operator output overwrite path pattern
    pictures points poses property quiet range refine resolution rhs rhs-property scaled show size source
    source-property steps threads time time-step tint truth up verbose version view views zero-property""".split()
# Defaults that depend on others in the code: the constant that holds the usual one.
USUAL = {"depth": "default_smallest_depth", "cube_scale": "default_cube_scale"}


def read_aliases(text):
    """the aliases of Doxygen, by name"""
    text = re.sub(r"\\\n\s*", "", text)
    return dict(re.findall(r'"named_(\w+)(?:\{1\})?=\s*([^"]*)"', text))


def expand(text, aliases):
    """`text` with the rows in place of the groups of rows"""

    def replacement(match):
        name, argument = match.groups()
        row = aliases.get(name, "")
        if "\\cgalParamNBegin" in row:
            return match.group(0)
        return expand(row.replace("\\1", argument or ""), aliases)

    return re.sub(r"\\named_(\w+)(?:\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\})?", replacement, text)


def constants_of(text):
    """constants and initialized variables, by name; the first one counts"""
    return dict(reversed(re.findall(r"(\w+)\s*=\s*([\w.:+-]+)[;,]", text)))


def same(a, b):
    """whether two literals have the same value"""
    try:
        return float(a) == float(b)
    except ValueError:
        return a.removesuffix("()") == b.removesuffix("()")


def arguments_of_python(package):
    """of each function its docstring, and the arguments that have a default: (name, default, function)"""
    docs, defaults = {}, []
    for path in sorted(package.glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef):
                docs.setdefault(node.name, ast.get_docstring(node) or "")
                own = zip(reversed(node.args.args), reversed(node.args.defaults))
                only = zip(node.args.kwonlyargs, node.args.kw_defaults)
                defaults += [(argument.arg, ast.literal_eval(value), node.name)
                             for argument, value in [*own, *only] if isinstance(value, ast.Constant)]
            elif isinstance(node, ast.ClassDef):
                docs.setdefault(node.name, ast.get_docstring(node) or "")
    return docs, defaults


def compare_python(root, rows, shown):
    """what Python says of a parameter of C++, and takes for it: one of the defaults that C++ has"""
    docs, defaults = arguments_of_python(root / "python/restricted_laplacian")
    errors, number = [], 0
    for argument in sorted(rows.keys() & {name for name, _, _ in defaults}):
        alias, row = rows[argument]
        text = re.search(r"\\cgalParamDefault\{(.*?)\\cgalParam", row).group(1)
        if text.startswith("\\1"):
            text = " ".join(re.findall(r"\\named_" + alias + r"\{([^}]*)\}", shown))
        # numbers, and those in functions that the text names
        bodies = [body for function in re.findall(r"\bdefault_\w+(?=\(\))", text) for body in re.findall(
            rf"^[^\n/]*\b{function}\([^;{{]*\{{\n?(.*?)\n?\}}", shown, re.M | re.S)]
        known = re.findall(r"(?<![\w.])\d[\d.]*(?:e-?\d+)?(?![\w.]*\w)", " ".join([text, *bodies]))
        found = [(function, str(float(value))) for other, value, function in defaults
                 if other == argument and type(value) in (int, float)]
        for function, doc in docs.items():
            for said in re.findall(rf"^{argument} : .*\n(?:    .*\n?)+", doc, re.M):
                figures = re.findall(r"\b(\d[\d.]*(?:e-?\d+)?) by default|default (\d[\d.]*(?:e-?\d+)?)\b", said)
                found += [(function, a or b) for a, b in figures]
        number += len(found)
        errors += [f"Python's {function} has the default {value} of {argument}, C++ {', '.join(sorted(set(known)))}"
                   for function, value in found if known and not any(same(value, v) for v in known)]
    if number < 12:
        errors.append(f"found only {number} defaults of Python; has their form changed?")
    return errors


def words_of_python(package):
    """the arguments with a default of public functions and methods"""
    words = set()

    def visit(nodes):
        for node in nodes:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                visit(node.body)
            elif isinstance(node, ast.FunctionDef) and (not node.name.startswith("_") or node.name == "__init__"):
                own = zip(reversed(node.args.args), reversed(node.args.defaults))
                only = zip(node.args.kwonlyargs, node.args.kw_defaults)
                words.update(argument.arg for argument, value in [*own, *only] if value is not None)

    tree = ast.parse((package / "__init__.py").read_text(encoding="utf-8"))
    public = next(ast.literal_eval(node.value) for node in tree.body
                  if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
    for path in sorted(package.glob("*.py")):
        visit([node for node in ast.parse(path.read_text(encoding="utf-8")).body
               if getattr(node, "name", "") in public or path.name == "learning.py"])
    return words


def words_of_programs(doc):
    """the options of programs, from what --help prints"""
    return {word for path in doc.glob("outputs/help_*.txt")
            for word in re.findall(r"^  --([a-z-]+)", path.read_text(encoding="utf-8"), re.M)}


def compare_words(names, of_python, of_programs):
    """words of Python and of programs that C++ does not know; and the table of those that it knows"""
    errors = [f"Python's argument {word} is no named parameter of C++" for word in sorted(
        of_python - names - set(PYTHON_ONLY))]
    errors += [f"the option --{word} is no named parameter of C++" for word in sorted(of_programs - set(PROGRAMS_ONLY))
               if word.removeprefix("no-").replace("-", "_") not in names]
    errors += [f"{word} is a named parameter of C++, too" for word in sorted(
        names & {*PYTHON_ONLY, *(word.replace("-", "_") for word in PROGRAMS_ONLY)})]
    errors += [f"Python has no argument {word}" for word in PYTHON_ONLY if word not in of_python]
    errors += [f"no program has the option --{word}" for word in PROGRAMS_ONLY if word not in of_programs]
    table = ["| C++ and Python | programs |", "|---|---|"]
    for name in sorted(names):
        word = name.replace("_", "-")
        options = [f"`--{option}`" for option in (word, "no-" + word) if option in of_programs]
        if options and name in of_python:
            table.append(f"| `{name}` | {', '.join(options)} |")
    for name, where in ("C++ and Python", of_python - {w.replace("-", "_").removeprefix("no_") for w in of_programs}), (
            "C++ and programs", {w.replace("-", "_") for w in of_programs} - of_python):
        found = ", ".join(f"`{word}`" for word in sorted(names & where))
        table.append(f"| {found} | only in {name} |")
    return errors, "\n".join(table)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=pathlib.Path, required=True)
    parser.add_argument("--update", action="store_true")
    given = parser.parse_args()
    root = given.root
    doc = root / "doc/Restricted_laplacian_3"
    headers = {p: p.read_text(encoding="utf-8") for p in sorted((root / HEADERS).rglob("*.h"))}
    aliases = read_aliases((doc / "named_parameters.doxy").read_text(encoding="utf-8"))
    page = (doc / "PackageDescription.txt").read_text(encoding="utf-8")
    errors = []

    rows = {}
    for alias, text in aliases.items():
        if match := re.match(r"\\cgalParamNBegin\{(\w+)\}", text):
            rows.setdefault(match.group(1), (alias, text))
    parameters = (root / HEADERS / "foundation/internal/parameters.h").read_text(encoding="utf-8")
    names = set(re.findall(r"PARAMETER\((?:\w+, )*([a-z_]+)\)", parameters))
    errors += [f"the manual does not know {name}" for name in sorted(names - rows.keys())]
    errors += [f"the sources do not know {name}" for name in sorted(rows.keys() - names)]

    shown = expand("\n".join(headers.values()), aliases)
    described = expand(page, aliases)
    for where, text in ("no function", shown), ("not the page of named parameters", described):
        found = set(re.findall(r"\\named_(\w+)", text))
        errors += [f"{where} shows {name}" for name in sorted(rows) if rows[name][0] not in found]
        errors += [f"there is no row for {alias}" for alias in sorted(found - aliases.keys())]

    everywhere = {}
    for text in headers.values():
        everywhere.update(
            re.findall(r"constexpr \w+\s+(default_\w+|\w+_with_constraints) = ([\w.-]+)[;,]", text)
        )
    for header, constant, group in CONSTANTS:
        value = constants_of(headers[root / HEADERS / header])[constant]
        said = re.findall(r"`([\w.-]+)`", expand(aliases[group], aliases))
        if not any(same(value, v) for v in said):
            errors.append(f"{constant} is {value}, which {group} does not say")
    manual = (doc / "Restricted_laplacian_3.txt").read_text(encoding="utf-8")
    exponent = re.search(r"default tolerance is\s+\\f\$10\^\{(-\d+)\}", manual)
    if not exponent or not same("1e" + exponent.group(1), everywhere["tolerance_with_constraints"]):
        errors.append("the User Manual has another default tolerance with prescribed values")

    number_of_defaults = 0
    for path, text in headers.items():
        known = constants_of(text)
        for variable in re.findall(r"std::optional<[^;<>]*> (\w+);", text):  # has no default in the code
            known.pop(variable, None)
        # of the functions that take these options
        takes = [f"const internal::{name}& np" for name in re.findall(r"struct (\w+_options) ", text)]
        users = [t for t in headers.values() if any(take in t for take in takes)]
        own_rows = expand("\n".join([text, *users]), aliases)
        reads = r"read_parameter\(np, internal_np::(\w+),\s*([\w.]+)\)"
        for name, variable in re.findall(reads, text):
            in_code = known.get(variable.split(".")[-1])
            in_code = known.get(in_code, everywhere.get(in_code, in_code))
            if name in USUAL:
                in_code = everywhere.get(USUAL[name])
            if in_code is None or in_code.startswith("default_") or name not in rows:
                continue
            alias, row = rows[name]
            default = re.search(r"\\cgalParamDefault\{(.*)", row).group(1)
            if default.startswith("\\1"):
                found = re.findall(r"\\named_" + alias + r"\{(`[\w.:-]+`)", own_rows)
            else:
                found = re.findall(r"^`.*?\}", default)
            number_of_defaults += len(found)
            errors += [
                f"{path.name}: the default of {name} is {in_code}, in the manual {text}"
                for text in found
                if not any(same(value, in_code) for value in re.findall(r"`([\w.:()-]+)`", text))
            ]
    if number_of_defaults < 25:
        errors.append(f"found only {number_of_defaults} defaults; has their form changed?")

    errors += compare_python(root, rows, shown)
    found, table = compare_words(names, words_of_python(root / "python/restricted_laplacian"), words_of_programs(doc))
    errors += found
    begin, end = "<!-- begin words -->\n", "\n<!-- end words -->"
    before, rest = page.split(begin)
    old, after = rest.split(end)
    if given.update:
        (doc / "PackageDescription.txt").write_text(before + begin + table + end + after, encoding="utf-8")
    elif old != table:
        errors.append("the table of names on the page of named parameters is not that of --update")
    print("\n".join(errors))
    print(f"{len(names)} named parameters, {number_of_defaults} defaults, {len(errors)} errors")
    return 1 if errors else 0


if __name__ == "__main__":
    raise SystemExit(main())
