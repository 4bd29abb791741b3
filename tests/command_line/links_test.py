"""Links of all documents lead somewhere: files of the tree, and headings in them."""
import re
import unittest

from program import SOURCE


def documents():
    # Not those of packages that the report's tools brought.
    return [file for file in SOURCE.rglob("*.md") if not {"node_modules", "build"} & set(file.relative_to(SOURCE).parts)]


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.S | re.M))


def anchors(file):
    """As web sites make them of headings."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", file.read_text(), flags=re.S | re.M), re.M):
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").strip().lower()
        found.add(re.sub(r"[^\w\- ]", "", text).replace(" ", "-"))
    return found


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        faults = []
        count = 0
        for document in documents():
            for target in re.findall(r"\]\(([^)\s]+)\)", without_code(document.read_text())):
                if re.match(r"[a-z]+:", target):
                    continue
                count += 1
                path, _, anchor = target.partition("#")
                file = (document.parent / path).resolve() if path else document
                name = f"{document.relative_to(SOURCE)}: {target}"
                if not file.exists():
                    faults.append(f"{name}: there is no such file")
                elif anchor and anchor not in anchors(file):
                    faults.append(f"{name}: there is no such heading")
        self.assertEqual(faults, [])
        self.assertGreater(count, 50)

    def test_every_document_is_reached_from_the_front_page(self):
        reached, rest = set(), [SOURCE / "README.md"]
        while rest:
            document = rest.pop()
            if document in reached or document.suffix != ".md" or not document.exists():
                continue
            reached.add(document)
            for target in re.findall(r"\]\(([^)#\s]+)", without_code(document.read_text())):
                file = (document.parent / target).resolve()
                rest.append(file / "README.md" if file.is_dir() else file)
        pages = set((SOURCE / "docs").glob("*.md"))
        self.assertTrue(pages)
        self.assertEqual({page.name for page in pages - reached}, set())


if __name__ == "__main__":
    unittest.main()
