"""Results for people and for other programs; each form of report is loaded on first use.

``telling``
    what a result says, once, in parts that every form of a report can show;
``tellings``
    a module for each verb, which makes the telling of its result;
``plain_text``, ``web``
    a telling as a text, and the parts of a web page; they know no verb;
``formats``, ``format_table``, ``file_format``
    the files that results can be written to, a module for each; their table; what a format is;
``rows``, ``world_rows``
    rows for programs, and those of costs in single worlds and runs;
``rendering``
    the telling of a result by its verb, and its texts;
``drawing``, ``scenes``, ``tours``, ``cost_curve``
    pictures of maps, of walks and of costs, and walks to show worlds by;
``text_layout``, ``markup``, ``project``
    what forms share: laws in a line each, tables and paragraphs, elements, the folder of files;
``schemas``
    the schemas of all documents;
``notebook``
    results as notebooks and ``print`` show them;
``play``
    the page in which the reader is the robot.
"""
