# The compiled part of the module, which nobody else imports.
from typing import Any

def __getattr__(name: str) -> Any: ...
