"""plumbline straightens NC programs for hexapod machine tools: it moves the tool tip to where the program means it to
go, against gravity, friction and elasticity of the machine.

Programs, models and tool tables are given as text or as a file: bytes, a str with a line end in it and an empty one are
text; any other str, and what os.fspath takes, is the path of a file; Text(text, name) is text that messages call `name`.

Options are those of the command by their long names, with _ for -: tolerance="1um", friction_turn=0.01, undo. True and
False are on and off; numbers between commas may be a sequence, as start=(0, 0, 100, 0, 0, 0); what may be repeated is a
list of texts, or a dict: work_offset={"G54": (0, 0, -1008, 0, 0, 0)}. None is no option.

Every function raises Error: Refused where the input is refused, WrongUsage where the call cannot be meant, Bug. The
interpreter's lock is released while they work. Ctrl-C ends compensate, check and simulate in the middle of their work.
"""

import decimal as _decimal
import functools as _functools
import json as _json
import numbers as _numbers
import os as _os

from . import _core

__version__ = _core.version
INTERFACE = _core.interface

__all__ = ["Bug", "Error", "INTERFACE", "Model", "Refused", "Result", "Table", "Text", "WrongUsage", "calibrate", "check",
           "compare", "compensate", "diagnose", "diff", "error", "explain", "identify", "map", "new_model",
           "restore", "simulate", "trace"]


class Error(Exception):
    """What is wrong: code, message, help (the way out), file, line and column (from 1; 0: the whole), length, text (the
    line); all of it as a dict in `diagnostic`. str() is what the command prints."""

    def __init__(self, json, text):
        super().__init__(text)
        self.diagnostic = _json.loads(json)
        for name in ("code", "message", "help", "file", "line", "column", "length", "text"):
            setattr(self, name, self.diagnostic[name])

    def __reduce__(self):
        return type(self), (_json.dumps(self.diagnostic), str(self))


class Refused(Error):
    """The input is refused, and nothing was written."""


class WrongUsage(Error, ValueError):
    """An option that there is not, or a value that is none."""


class Bug(Error):
    """A bug of plumbline: please report it."""


_core.raise_as([Refused, WrongUsage, Bug])


class Text:
    """Text in memory (str or bytes) that messages call `name`; files that it refers to are looked for beside that name."""

    def __init__(self, text, name="<text>"):
        self.bytes = _bytes(text)
        self.name = _os.fspath(name)


class Model:
    """A machine's model, read and checked once. name: of the machine; hash: of its text, as compensated programs name it;
    text: the file's."""

    def __init__(self, source):
        self._core = _core.Model(_input(source))

    @property
    def name(self):
        return self._core.name

    @property
    def hash(self):
        return self._core.hash

    @property
    def text(self):
        return _str(self._core.bytes)

    def __repr__(self):
        return f"<plumbline.Model {self.name}, {self.hash}>"

    def __reduce__(self):
        return _model_of, (self._core.bytes, self._core.file)


@_functools.lru_cache(maxsize=16)
def _model_of(text, name):
    """Of a process to which a model is sent with every job: it is read once."""
    return Model(Text(text, name))


class Result:
    """What a function found. text: the program, for compensate; undo: what restore gives the original back with; summary:
    a dict, as the command writes it with --json; words: as it says it; warnings: dicts; found: limits are broken, programs
    differ, or a bound is exceeded; model: the model file that was learnt or made (raises Refused where something speaks
    against it)."""

    def __init__(self, core, text=None, undo=None):
        self._core = core
        self.summary = _json.loads(core.json)
        self.words = _str(core.words)
        self.warnings = [_json.loads(warning) for warning in core.warnings]
        self.found = core.found
        self.bytes = text
        self.text = None if text is None else _str(text)
        self.undo = undo or None

    @property
    def model(self):
        if self._core is not None:
            return _str(self._core.model)
        if isinstance(self._model, Error):
            raise self._model
        return self._model

    def __getstate__(self):
        """For another process: all of it is text."""
        try:
            model = self.model
        except Error as error:
            model = error
        return {**self.__dict__, "_core": None, "_model": model}

    def __repr__(self):
        return f"<plumbline.Result {self.summary.get('plumbline', '')}>"


class Table:
    """Numbers in named columns. columns: their names, with the unit at the end; values: an array (rows, columns);
    table["dz_um"]: a column of it."""

    def __init__(self, columns, values):
        self.columns = columns
        self.values = values

    def __len__(self):
        return len(self.values)

    def __getitem__(self, column):
        try:
            return self.values[:, self.columns.index(column)]
        except ValueError:
            raise KeyError(column) from None

    def __repr__(self):
        return f"<plumbline.Table of {len(self)} rows: {', '.join(self.columns)}>"


def _bytes(text):
    if isinstance(text, str):
        return text.encode("utf-8", "surrogateescape")
    if isinstance(text, (bytes, bytearray, memoryview)):
        return bytes(text)
    raise TypeError(f"a text is a str or bytes, not {type(text).__name__}")


def _str(text):
    return text.decode("utf-8", "surrogateescape")


def _is_text(source):
    if isinstance(source, str):
        return "\n" in source or source == ""
    return isinstance(source, (bytes, bytearray, memoryview))


def _input(source):
    if isinstance(source, Text):
        return _core.Text(source.name, source.bytes)
    if _is_text(source):
        return _core.Text("<text>", _bytes(source))
    return _core.Text(_os.fspath(source), None)


def _model(model):
    if model is None:
        return None
    return (model if isinstance(model, Model) else Model(model))._core


def _value(value):
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, _numbers.Integral):
        return str(int(value))
    if isinstance(value, (_numbers.Real, _decimal.Decimal)):
        return repr(float(value))
    if hasattr(value, "__fspath__"):
        return _os.fspath(value)
    return ",".join(_value(one) for one in value)


def _options(given):
    options = []
    for key, value in given.items():
        name = key if "." in key else key.rstrip("_").replace("_", "-")  # with_: a word of Python
        if value is None:
            continue
        if isinstance(value, dict):
            options += [(name, f"{of}={_value(one)}") for of, one in value.items()]
        elif isinstance(value, list) and value and all(isinstance(one, str) for one in value):
            options += [(name, one) for one in value]
        elif isinstance(value, Text) or (value != "" and _is_text(value)):
            options.append((name, _input(value)))
        else:
            options.append((name, _value(value)))
    return options


def _told(progress):
    """The work calls it now and then; Python sees there, too, whether Ctrl-C was pressed."""
    if progress is None:
        return _nobody_is_told
    if not callable(progress):
        raise TypeError(f"progress: expected a function of (done, total), not {type(progress).__name__}")
    return progress


def _nobody_is_told(done, total):
    pass


def compensate(program, model=None, *, undo=False, progress=None, **options):
    """Corrects a program for a machine: a Result with its text, and with undo=True what restore needs. The model may be
    left out where settings=... and machine=... name one. progress(done, total) is called now and then; what it raises ends
    the work."""
    core, text, log = _core.compensate(_input(program), _model(model), _options(options), undo, _told(progress))
    return Result(core, text, log)


def check(program, model=None, *, progress=None, **options):
    """All places where a program, compensated, breaks limits of the machine; found says whether there are some."""
    return Result(_core.check(_input(program), _model(model), _options(options), _told(progress)))


def diff(a, b, model=None, **options):
    """How far program b moves the tool away from where a takes it; found: by more than tolerance_mm, tolerance_deg."""
    return Result(_core.diff(_input(a), _input(b), _model(model), _options(options)))


def trace(program, model=None, **options):
    """The motion of a program, a dict each: line, motion, to, machine (mm, deg), feed, feed_mode."""
    text = _core.trace(_input(program), _model(model), _options(options))
    return [_json.loads(line) for line in text.splitlines()]


def restore(program, undo):
    """The original of a compensated program, from Result.undo or the file that the command wrote."""
    return _str(_core.restore(_input(program), _input(undo)))


def simulate(program, model=None, *, progress=None, **options):
    """Plays a program, as it stands, on the model: a Table with a row for every point of the path. motion is 0 for rapids,
    1 for cuts along lines, 2 for arcs."""
    return Table(*_core.simulate(_input(program), _model(model), _options(options), _told(progress)))


def error(poses, model):
    """The error of the tool tip at poses, an array (n, 6) of x, y, z in mm and a, b, c in deg in the machine's base frame,
    the machine at rest: a Table with strut lengths, nut tensions, stretches and errors beside them. Warns (UserWarning) where the model's limits leave a pose out."""
    import numpy

    poses = numpy.asarray(poses, dtype=float)
    if not numpy.isfinite(poses).all():
        raise ValueError("poses: a number in it is not finite")
    return Table(*_core.error(poses, _model(model)))


def identify(model, dataset, **options):
    """Learns the model's parameters from circular tests, the path of a dataset.toml: a Result with a model."""
    return Result(_core.identify(_model(model), _os.fspath(dataset), _options(options)))


def calibrate(model, dataset=None, **options):
    """Finds joints and strut offsets from circular tests, a tracker's poses=..., or both: a Result with a model."""
    return Result(_core.calibrate(_model(model), "" if dataset is None else _os.fspath(dataset), _options(options)))


def diagnose(model, dataset, **options):
    """Finds which effect a model misses: a Result with a model."""
    return Result(_core.diagnose(_model(model), _os.fspath(dataset), _options(options)))


def compare(model, dataset, **options):
    """A model against measurements; found: the readings of the bar are further off than max_radial_um."""
    return Result(_core.compare(_model(model), _os.fspath(dataset), _options(options)))


def new_model(**options):
    """The model file of a machine from what is stated of it: a Result with a model. Keys of the file are options, too:
    **{"strut.length_min_mm": 700}."""
    return Result(_core.new_model(_options(options)))


def explain(code=None):
    """What the code of a diagnostic means and what to do; without one all codes, a line each."""
    return _str(_core.explain(code))


def map(jobs, executor=None, *, function=compensate):
    """Does each of the jobs, dicts of the arguments of `function`, and gives what became of each, in their order: what the
    function returned, or the Error that it raised, so that one that is refused does not end the others. The jobs run on any
    executor of concurrent.futures: threads or processes of this machine, workers of others (Dask's Client.get_executor());
    without one here, one after the other. Jobs depend on nothing but their arguments: one that is done twice, because a
    worker went away, gives the same."""
    if executor is None:
        return (_outcome(function, job) for job in jobs)
    futures = [executor.submit(_outcome, function, job) for job in jobs]
    return (future.result() for future in futures)


def _outcome(function, job):
    try:
        return function(**job)
    except Error as error:
        return error
