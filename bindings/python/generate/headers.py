"""headers.py - the comments of the headers: what is said of functions, structs and their members."""

import re
import textwrap


def plain(comment):
    """The text in /* ... */, without the column of stars; paragraphs keep their lines."""
    lines = comment.strip()[2:-2].splitlines()
    lines = [lines[0].strip(), *(re.sub(r"^\s*\* ?", "", line).rstrip() for line in lines[1:])]
    return "\n".join([lines[0], textwrap.dedent("\n".join(lines[1:]))]).strip()


def flowing(comment):
    """The text in a comment beside a member, as one line."""
    return " ".join(comment.strip()[2:-2].split())


class Comments:
    """`structs`, `functions`: text by name; `members`: by (struct, member)."""

    def __init__(self, files):
        text = "\n".join(file.read_text() for file in files)
        self.structs, self.members, self.functions = {}, {}, {}
        for comment, name, body in re.findall(
            r"(/\*(?:(?!\*/).)*\*/\n)?typedef struct (rsh_\w+) \{(.*?)\n\}", text, re.DOTALL
        ):
            self.structs[name] = plain(comment) if comment else ""
            self.add_members(name, body)
        self.add_functions(text)

    def add_members(self, struct, body):
        for declared, comment in re.findall(r"([^;/]+);\s*(/\*.*?\*/)?", body, re.DOTALL):
            for name in re.findall(r"(\w+)(?:\[[^\]]*\])?\s*(?:,|$)", declared):
                self.members[struct, name] = flowing(comment) if comment else ""

    def add_functions(self, text):
        """A comment is for the declaration that follows; of a call and its query, for both."""
        for comment, name in re.findall(
            r"(/\*(?:(?!\*/).)*\*/\n)?RSH_API [^;(]*?(rsh_\w+)\(", text, re.DOTALL
        ):
            self.functions[name] = plain(comment) if comment else ""
        for name, said in self.functions.items():
            call = name.removesuffix("_query")
            if call != name:
                self.functions[call] = self.functions[call] or said
                self.functions[name] = f"Tell how many bytes {call} needs, of the same arguments."
