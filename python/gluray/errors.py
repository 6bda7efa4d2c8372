"""What goes wrong, as one line that says what to do."""


class GlurayError(Exception):
    """A request that failed: no program runs, a name or a value is wrong, the hub ended. str() is one line."""


class HubError(GlurayError):
    """There is no connection to a hub: none runs, it does not answer, or the keys differ."""
