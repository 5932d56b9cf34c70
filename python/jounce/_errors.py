# SPDX-License-Identifier: Apache-2.0
"""The exceptions of Jounce. Each has the parts of its message as attributes."""


class InputError(ValueError):
    """An error in the input: a value that breaks a rule, with its place if it is in a file."""

    def __init__(self, text: str, file: str = "", line: int = 0, column: int = 0, key: str = "", value: str = "",
                 rule: str = "") -> None:
        super().__init__(text)
        self.file = file
        """Name of the file; empty: not in a file."""
        self.line = line
        """Line, from 1; 0: unknown."""
        self.column = column
        """Column, from 1; 0: unknown."""
        self.key = key
        """Name of the parameter, such as segment[2].end.master."""
        self.value = value
        """The value as text."""
        self.rule = rule
        """The rule that the value breaks, such as "must be > 0"."""
        self.errors: tuple["InputError", ...] = (self,)
        """All errors of the document, in the order of reading; the first one is this error."""

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (str(self), self.file, self.line, self.column, self.key, self.value, self.rule),
                {"errors": self.errors})


class MoveError(ValueError):
    """No move exists between the two states within the bounds."""

    def __init__(self, text: str, status: str = "") -> None:
        super().__init__(text)
        self.status = status
        """The reason as a word: "too_short", "target_outside", ..."""

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.status)


class AxisError(RuntimeError):
    """An executor rejected a command or a table, or did not answer."""

    def __init__(self, text: str, error: str = "", refusal: str = "", cause: int = 0) -> None:
        super().__init__(text)
        self.error = error
        """Kind of the failure: "refused", "no_answer", "contact_lost", ..."""
        self.refusal = refusal
        """Reason as a word, if the call was rejected: "position_limit", "busy", ..."""
        self.cause = cause
        """Number of the cause on the axis; 0: none."""

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.error, self.refusal, self.cause)


class AxisTimeout(AxisError, TimeoutError):
    """An executor did not answer in time, or an axis did not reach its state in time."""
