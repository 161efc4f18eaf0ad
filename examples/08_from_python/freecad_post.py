"""plumbline behind a post-processor of FreeCAD: what the post exports is straightened before it is saved.

A post of FreeCAD is a module with export(objects, filename, arguments), which gives the program as a string. straightened()
makes another such function of it; in a module of your own, say straight_linuxcnc_post.py in FreeCAD's macro folder:

    from linuxcnc_post import export as plain_export
    from freecad_post import straightened
    export = straightened(plain_export, settings="/etc/plumbline/shop.toml", machine="hex-3")
"""
import os

import plumbline


def straightened(export, model=None, **options):
    """The same export function, whose program is compensated. Of a program that plumbline refuses nothing is saved: it
    raises plumbline.Refused, whose text says why, and a file of an earlier export stays as it is."""

    def straight_export(objects, filename, arguments=""):
        program = export(objects, "-", arguments)  # "-": FreeCAD's posts save nothing then
        done = plumbline.compensate(plumbline.Text(program, filename), model, **options)
        print(done.words)
        for warning in done.warnings:
            print(f"{warning['file']}:{warning['line']}: warning: {warning['message']}\nhelp: {warning['help']}")
        if filename != "-":
            save(done.bytes, filename)
        return done.text

    return straight_export


def save(program, filename):
    """The whole program or, where that does not go, the file as it was."""
    passing = filename + ".passing"
    try:
        with open(passing, "wb") as file:
            file.write(program)
        os.replace(passing, os.path.realpath(filename))
    except BaseException:
        if os.path.exists(passing):
            os.remove(passing)
        raise
