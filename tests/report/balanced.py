"""Exits with 1, and says where, unless every element of an HTML page is closed in order."""

import sys
from html.parser import HTMLParser

VOID = {"meta", "img", "br", "input"}


class Balance(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open = []
        self.elements = 0

    def handle_starttag(self, tag, attributes):
        self.elements += 1
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            sys.exit(f"line {self.getpos()[0]}: </{tag}> closes nothing that is open")


page = Balance()
page.feed(open(sys.argv[1], encoding="utf-8").read())
if page.open or page.elements < 20:
    sys.exit(f"open at the end: {page.open}; {page.elements} elements")
