"""Requests to several programs at once: those that are silent delay all others by one limit of time together."""
import json

from . import hub
from .errors import GlurayError, HubError


def ask(requests):
    """Sends pairs of a request and its programs. Returns results, and lines of what failed, both by Program. Raises HubError, and
    GlurayError where the hub refuses."""
    results, failures, asked = {}, {}, []
    for request, programs in requests:
        numbers = {}
        for p in programs:
            try:
                if p.in_process:
                    results[p] = p._ask(request)
                else:
                    numbers[p._number()] = p
            except HubError:
                raise
            except GlurayError as error:
                failures[p] = str(error)
        if numbers:
            asked.append((request, numbers))
    for numbers, answer in _answers(asked, failures):
        for number, p in numbers.items():
            try:
                results[p] = p._result(answer, number)
            except GlurayError as error:
                failures[p] = str(error)
    return results, failures


def _answers(asked, failures, again=True):
    """Pairs of numbered programs and the hub's answer. The hub refuses a request if one of its programs has ended: then the others are asked again."""
    of = [p._generation for _, numbers in asked for p in numbers.values()]
    try:
        answers = hub.ask_all([{**request, "program": list(numbers)} for request, numbers in asked], of[0]) if asked else []
    except (TypeError, ValueError) as error:
        raise GlurayError(f"a value is no boolean, number, text or list: {error}") from None
    refused = [(request, numbers, answer) for (request, numbers), answer in zip(asked, answers) if isinstance(answer, GlurayError)]
    done = [(numbers, answer) for (_, numbers), answer in zip(asked, answers) if not isinstance(answer, GlurayError)]
    if not refused:
        return done
    entries = hub.ask({"type": "list"}, of[0]).get("programs")
    there = {entry.get("program") for entry in entries if isinstance(entry, dict)} if isinstance(entries, list) else {}
    ended = {number: p for _, numbers, _ in refused for number, p in numbers.items() if number not in there}
    if not ended or not again:
        raise refused[0][2]
    failures.update({p: f"{p.name} ({p.pid}): it has ended" for p in ended.values()})
    rest = [(request, {number: p for number, p in numbers.items() if number in there}) for request, numbers, _ in refused]
    return done + _answers([(request, numbers) for request, numbers in rest if numbers], failures, again=False)


def named(programs, names):
    """The programs by the settings that the names mean to them: {("ao", "ao.samples"): [p, q]}, and failures by Program."""
    strange = any(isinstance(name, str) and "_" in name for name in names)
    unknown = [p for p in programs if strange and p._names is None]
    described, failures = ask([({"type": "describe"}, [p]) for p in unknown])  # one answer for all might be longer than a message
    for p, result in described.items():
        p._take_names(result)
    groups = {}
    for p in programs:
        if p not in failures:
            try:
                groups.setdefault(tuple(p.resolve(name) for name in names), []).append(p)
            except GlurayError as error:
                failures[p] = str(error)
    return groups, failures


def set(programs, values):
    """Changes settings of these programs. Returns results and failures as ask()."""
    groups, unnamed = named(programs, list(values))
    requests = [({"type": "set", "values": dict(zip(names, values.values()))}, some) for names, some in groups.items()]
    results, failures = ask(requests)
    return results, {**unnamed, **failures}


def values(programs, names):
    """What the settings are: {p: {"ao": {"value": True, "layer": "live", "place": ""}}}, and failures as ask()."""
    groups, unnamed = named(programs, names)
    results, failures = ask([({"type": "get", "names": list(known)}, some) for known, some in groups.items()])
    found = {}
    for p, result in results.items():
        known = next(known for known, some in groups.items() if p in some)
        got = result.get("values")
        if isinstance(got, dict) and all(isinstance(got.get(name), dict) and "value" in got[name] for name in known):
            found[p] = {name: got[name] for name in known}
        else:
            failures[p] = f"{p.name} ({p.pid}): it does not answer"
    return found, {**unnamed, **failures}


def give_back(before):
    """Gives settings what values() found. Returns results and failures as ask()."""
    groups = {}
    for p, found in before.items():
        changes = {name: one["value"] if one.get("layer") == "live" else None for name, one in found.items()}
        groups.setdefault(json.dumps(changes), (changes, []))[1].append(p)
    return ask([({"type": "set", "values": changes}, some) for changes, some in groups.values()])


def check(programs, failures):
    """Raises GlurayError with the lines of the programs that failed, in their order."""
    lines = [failures[p] for p in programs if p in failures]
    if lines:
        raise GlurayError("; ".join(lines))
