"""Class of the commands, which rejects repeated options."""

from __future__ import annotations

from typing import Any

from typer.core import TyperCommand


class Command(TyperCommand):
    """Command that rejects a second value of an option, which would replace the first one."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the arguments after the command.

        Raises
        ------
        InputError
            If an option with one value has several.
        """
        from flowlanes.errors import InputError

        _, _, given = self.make_parser(ctx).parse_args(list(args))
        for parameter in given:
            single = not (getattr(parameter, "is_flag", True) or parameter.multiple)
            if single and sum(other is parameter for other in given) > 1:
                name = max(parameter.opts, key=len)
                raise InputError(f"{name} is given twice: leave out one of them")
        return super().parse_args(ctx, args)
