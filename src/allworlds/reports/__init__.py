"""Results for people and for other programs; each form of report is loaded on first use.

``parts``
    the parts of a report's content, among them scenes (the contents of pictures in every form) and
    rows for files such as CSV;
``content``
    the content of each verb's report;
``plain_text``, ``web``
    content as a text, and as a web page; these modules know no verb;
``formats``
    the table of the formats; the texts and files of a verb's result, including the files for CI
    services;
``drawing``
    pictures of maps, of worlds and of walks;
``schemas``
    the schemas of all documents;
``notebook``
    results in the form in which notebooks and ``print`` show them.
"""
