"""plumbline behind a post-processor of FreeCAD: what the post exports is straightened before it is saved.

A post of FreeCAD is a module with export(objects, filename, arguments), which gives the program as a string. straightened()
makes another such function of it; in a module of your own, say straight_linuxcnc_post.py in FreeCAD's macro folder:

    from linuxcnc_post import export as plain_export
    from freecad_post import straightened
    export = straightened(plain_export, settings="/etc/plumbline/shop.toml", machine="hex-3")
"""
import plumbline


def straightened(export, model=None, **options):
    """The same export function, whose program is compensated. A program that plumbline refuses is not saved."""

    def straight_export(objects, filename, arguments=""):
        program = export(objects, "-", arguments)  # "-": FreeCAD's posts save nothing then
        done = plumbline.compensate(plumbline.Text(program, filename), model, **options)
        print(done.words)
        if filename != "-":
            with open(filename, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
                file.write(done.text)
        return done.text

    return straight_export
