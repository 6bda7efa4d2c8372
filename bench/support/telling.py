"""Messages of a suite that cannot measure or is interrupted."""
import signal
import sys

from support import programs
from support.display import NoDisplay


def _interrupted(number, _frame):
    raise KeyboardInterrupt(number)


def end_by_exception():
    """Makes signals that end us raise KeyboardInterrupt, so that child processes end, too."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):  # a shell starts background jobs with SIGINT ignored
        signal.signal(number, _interrupted)


def status_of(run, *others):
    """The exit status of run(): 0, or 1 and one line if a display, a program or, by `others`, something else is missing;
    130 if a signal ends it, after its child processes have ended."""
    end_by_exception()
    try:
        run()
    except KeyboardInterrupt:
        print("bench: interrupted; nothing is written", file=sys.stderr)
        return 130
    except (NoDisplay, programs.Failed, *others) as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    return 0
