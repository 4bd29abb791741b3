#!/usr/bin/env python3
"""Keeps the words of the dialect out: fails where one of words.txt stands, and prints the place.

Counted are texts, which users read (string literals of C++ and of the report's JavaScript, Markdown without its code),
and comments, also those of vehicle files, studies and CMake. A literal of one word, such as "march", is a name and
does not count.

Remedy for a failure: write the field's word, or give words.txt an exception with its reason.
"""
import collections
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
DOCUMENTS = ("*.md", "docs/**/*.md", "urdf/README.md", "meshes/README.md", "studies/**/README.md",
             "analysis/report/README.md", "tests/**/README.md")
# Versions that are out keep their words.
OLD = {"CHANGELOG.md"}
MARKED_UP = ("urdf/*.urdf", "studies/**/*.urdf")
CONFIGURED = ("studies/**/*.yaml", "cmake/*.cmake", "**/CMakeLists.txt")
CODE = ("analysis/**/*.cpp", "analysis/**/*.h", "analysis/report/web/**/*.js", "vehicles/**/*.cpp", "vehicles/**/*.h",
        "identify/**/*.cpp", "identify/**/*.h", "include/**/*.h")
SKIPPED = {"node_modules", "bundle", "build"}
NOT_PROSE = r"^```.*?^```|`[^`\n]*`|\]\([^)]*\)|<!--.*?-->"
TOKEN = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)"""
                   r"""|R"(?P<tag>\w*)\(.*?\)(?P=tag)"|"(?:[^"\\\n]|\\.)*\""""
                   r"""|\d'(?=\d)|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`""", re.S)

Word = collections.namedtuple("Word", "name layers pattern exceptions")
Place = collections.namedtuple("Place", "file line word kind")


def compiled(pattern):
    return re.compile(pattern.replace(" ", r"\s+"), re.I)


def read_words():
    """The words of words.txt, each with its exceptions."""
    lines = (HERE / "words.txt").read_text().splitlines()
    cells = [re.split(r" +\| ", line) for line in lines if line and not line.startswith("#")]
    allowed = collections.defaultdict(list)
    for row in cells:
        if row[0] == "allow":
            allowed[row[1]].append(compiled(row[2]))
    return [Word(row[1], row[2].split(), compiled(row[3]), allowed["*"] + allowed[row[1]])
            for row in cells if row[0] == "word"]


def blank(match):
    """White space in the place of a match, its lines kept."""
    return re.sub(r"[^\n]", " ", match.group())


def layers_of_code(text):
    """The file once for each kind of token, NUL in the place of all else: neighbours of a kind read as one sentence."""
    text = re.sub(r"^ *#include[^\n]*", blank, text, flags=re.M)
    layers = {kind: list(re.sub(r"\S", "\0", text)) for kind in ("text", "comment")}
    for token in TOKEN.finditer(text):
        piece = token.group()
        if token["comment"]:
            kind, piece = "comment", re.sub(r"^\s*(?://+|/?\*+)", blank, piece, flags=re.M)
        else:
            kind, inner = "text", piece[1:-1]
            if not re.search(r"\s", inner):
                continue
            piece = " " + re.sub(r"\\.", blank, inner, flags=re.S) + " "
        layers[kind][token.start():token.end()] = piece
    return {kind: "".join(layer) for kind, layer in layers.items()}


def layers_of_document(text):
    return {"text": re.sub(NOT_PROSE, blank, text, flags=re.S | re.M)}


def layers_of_markup(text):
    """Comments alone: names of vehicle files are the user's."""
    inside = re.sub(r"(?:\A|-->).*?(?:<!--|\Z)", blank, text, flags=re.S)
    return {"comment": inside}


def layers_of_configuration(text):
    """Comments from '#' to the end of the line."""
    return {"comment": re.sub(r"^[^#\n]*#?|(?<=\n)[^#\n]*$", blank, text, flags=re.M)}


def files():
    for patterns, layers in ((DOCUMENTS, layers_of_document), (CODE, layers_of_code), (MARKED_UP, layers_of_markup),
                             (CONFIGURED, layers_of_configuration)):
        for file in sorted(file for pattern in patterns for file in SOURCE.glob(pattern)):
            if not SKIPPED & set(file.relative_to(SOURCE).parts) and file.name not in OLD:
                yield file.relative_to(SOURCE), layers(file.read_text())


def places(words):
    """Each place of a word outside its exceptions."""
    for file, layers in files():
        for word in words:
            for kind in set(word.layers) & set(layers):
                layer = layers[kind]
                matches = list(word.pattern.finditer(layer))
                # Few layers have the word, so that few need its exceptions.
                spans = [match.span() for exception in word.exceptions if matches for match in exception.finditer(layer)]
                for match in matches:
                    if not any(begin <= match.start() and match.end() <= end for begin, end in spans):
                        line = layer.count("\n", 0, match.start()) + 1
                        yield Place(file, line, word.name, kind)


def main():
    found = list(places(read_words()))
    for place in found:
        text = (SOURCE / place.file).read_text().splitlines()[place.line - 1].strip()
        print(f"{place.file}:{place.line}: '{place.word}' in a {place.kind}: {text}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
