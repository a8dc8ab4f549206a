"""A result as one page that needs nothing else: no network, no other file, no script to be read.

``pages``
    **the** table of the kinds of pages, by the verb;
``checks``, ``runs``, ``lookalikes``, ``most_expensive``, ``comparison``
    what each kind says;
``frame``
    what every page has round it;
``findings``, ``viewer``, ``walk``, ``plot``
    parts of pages: a finding, pictures to step through, a walk as a list of steps, and cost
    against bound;
``beside``, ``known``
    pictures of two maps side by side, and of what an explorer knows beside its world;
``style.css``, ``script.js``
    what a page looks like, and the keys that step along a walk.
"""
