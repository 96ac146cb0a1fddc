"""What can go wrong with sessions, one sentence each for the user as it stands."""

NO_SESSION = "There is no session {!r}: `c2s sessions list` names those that there are."


class SessionError(ValueError):
    """A session that cannot be opened, changed or read; the message says why and what to do."""


class SessionInUse(SessionError):
    """A session that another process holds open."""
