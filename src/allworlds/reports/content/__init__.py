"""The content of the report of each verb; the table of the verbs names the function of each."""
