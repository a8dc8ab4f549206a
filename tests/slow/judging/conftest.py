"""The fixtures of the quick tests beside them."""

from judging import conftest as quick

finding_of = quick.finding_of
told = quick.told
answering = quick.answering
explained = quick.explained
