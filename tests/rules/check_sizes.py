"""A file is one equation, operator or noun (at most 300 lines), a function fits on a screen (at most 60)."""

import ast
import re

import tree

FILE_LINES, FUNCTION_LINES = 300, 60
DATA = "\x01"
SCOPE = re.compile(r"\b(namespace|struct|class|union|enum|extern)\b[^()]*$")


def without_text(source):
    """The source with comments, strings and preprocessor lines blanked, line breaks kept."""
    pattern = re.compile(
        r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.S | re.M
    )
    # digit separators (1'000) would open a character constant
    source = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "", source)
    return pattern.sub(blanked, source)


def blanked(match):
    """Spaces for text; the inner lines of a raw string (data, not logic) carry a mark, so that they are not counted."""
    text = re.sub(r"[^\n]", " ", match.group())
    return text.replace("\n", "\n" + DATA) if match.group().startswith("R") else text


def cpp_functions(source):
    """(first line, name, lines) of every function that is not inside another."""
    text = without_text(source)
    rows, scopes, start = text.split("\n"), [], 0
    for position, character in enumerate(text):
        if character in ";{}":
            head = text[start:position]
            start = position + 1
        if character == "{":
            inside = any(kind != "scope" for kind, _, _ in scopes)
            is_scope = bool(SCOPE.search(head.strip())) and not inside
            is_function = not inside and not is_scope and "(" in head and "=" not in head.split("(")[0]
            kind = "scope" if is_scope else "function" if is_function else "other"
            name = re.findall(r"([\w:~]+)\s*\(", head)
            scopes.append((kind, text.count("\n", 0, position) + 1, name[0] if name else "?"))
        elif character == "}" and scopes:
            kind, line, name = scopes.pop()
            if kind == "function":
                last = text.count("\n", 0, position) + 1
                data = sum(row.startswith(DATA) for row in rows[line - 1 : last])
                yield line, name, last - line + 1 - data


def python_functions(source):
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.name, node.end_lineno - node.lineno + 1


def offenders_in(path):
    source = tree.read(path)
    lines = source.count("\n") + (not source.endswith("\n"))
    if lines > FILE_LINES:
        yield f"{path}: {lines} lines, at most {FILE_LINES}"
    functions = python_functions(source) if path.suffix == ".py" else cpp_functions(source)
    for line, name, length in functions:
        if length > FUNCTION_LINES:
            yield f"{path}:{line}: {name} has {length} lines, at most {FUNCTION_LINES}"


if __name__ == "__main__":
    tree.finish("sizes", [o for path in tree.sources() for o in offenders_in(path)])
