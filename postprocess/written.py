"""Reads the JSON files that `verify` wrote; whoever asks for what is not there is told so in a sentence, with what there is instead."""

import json
import sys
from pathlib import Path


class Unusable(Exception):
    """What was asked for is not there or cannot be read: bad input."""


def folder_of(name):
    """The folder of a campaign."""
    folder = Path(name)
    if not folder.is_dir():
        raise Unusable(f"{name} is no folder; name one that `verify run --output` wrote")
    return folder


def read_json(path, others=()):
    """The content of a JSON file; `others`: files of its kind, named where this one is missing."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        names = ", ".join(str(other) for other in sorted(others)) or "none"
        raise Unusable(f"there is no {path}; of its kind there are: {names}") from None
    except (OSError, ValueError) as error:
        raise Unusable(f"{path} cannot be read ({error}); let `verify` write it again") from None


def read_shaped(path, *keys, others=()):
    """The content of a JSON file that must be a table with these keys."""
    content = read_json(path, others)
    lacking = [key for key in keys if not isinstance(content, dict) or key not in content]
    if lacking:
        raise Unusable(f"{path} has no {', '.join(lacking)}: no file of `verify`, or of another version of it; let `verify` write it again")
    return content


def write_whole(path, text):
    """Writes a text file, whole or not at all."""
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(text, encoding="utf-8")
        part.replace(path)
    except OSError as error:
        raise Unusable(f"{path} cannot be written ({error.strerror}); choose a folder that can") from None


def program(name, main):
    """Ends the process with the exit code of main(arguments), or with 2 and one sentence."""
    try:
        sys.exit(main(sys.argv[1:]))
    except Unusable as reason:
        print(f"{name}: {reason}", file=sys.stderr)
        sys.exit(2)
