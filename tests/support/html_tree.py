"""A page as a tree of elements, which is read strictly."""

from html.parser import HTMLParser

VOID = {"meta", "br", "link", "img", "input", "hr"}


class Node:
    def __init__(self, name, attributes):
        self.name, self.attributes, self.children = name, dict(attributes), []

    def all(self, name=None, **wanted):
        for child in self.children:
            if isinstance(child, Node):
                has = child.attributes
                fits = all(has.get(k.replace("_", "-").rstrip("-")) == v for k, v in wanted.items())
                if fits and name in (None, child.name):
                    yield child
                yield from child.all(name, **wanted)

    def one(self, name=None, **wanted):
        (found,) = self.all(name, **wanted)
        return found

    @property
    def text(self):
        return "".join(child.text if isinstance(child, Node) else child for child in self.children)


class Reader(HTMLParser):
    """A tree of a page in which every element is closed where it should be."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.root = Node("", ())
        self.open = [self.root]
        self.feed(text)
        self.close()
        assert self.open == [self.root]

    def handle_starttag(self, tag, attrs):
        assert len(dict(attrs)) == len(attrs)
        node = Node(tag, attrs)
        self.open[-1].children.append(node)
        if tag not in VOID:
            self.open.append(node)

    def handle_endtag(self, tag):
        assert self.open.pop().name == tag

    def handle_data(self, data):
        self.open[-1].children.append(data)


def read(text):
    assert text.startswith('<!DOCTYPE html>\n<html lang="en">')
    return Reader(text).root
