"""The tools as stages, those too that need no dataset: asperity.stage.generate(...)."""
from . import _calls, _options


def __getattr__(name):
    return _calls.function(name, waits=True)


def __dir__():
    return [_options.python_name(name) for name in _options.names()]
