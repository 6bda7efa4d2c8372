"""What a suite says where it cannot measure."""
import sys

from support import programs
from support.display import NoDisplay


def status_of(run, *others):
    """run()'s end as an exit status: 0, or 1 and one line where a display, a program or, by `others`, something else is missing."""
    try:
        run()
    except (NoDisplay, programs.Failed, *others) as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    return 0
