#!/usr/bin/python3
"""Shows base, struts, platform and tool of the hexapod that LinuxCNC simulates, as they move. LinuxCNC starts it
([APPLICATIONS] of hexapod.ini). Drag to look from elsewhere, turn the wheel to come nearer. Written by plumbline."""

import math

STRUTS = range(6)
SIZE = 640  # px


def turned(angles_deg, v):
    """R v, R = Rz(C) Ry(B) Rx(A)."""
    a, b, c = (math.radians(angle) for angle in angles_deg)
    x, y, z = v
    y, z = math.cos(a) * y - math.sin(a) * z, math.sin(a) * y + math.cos(a) * z
    x, z = math.cos(b) * x + math.sin(b) * z, -math.sin(b) * x + math.cos(b) * z
    return math.cos(c) * x - math.sin(c) * y, math.sin(c) * x + math.cos(c) * y, z


def stand(position, tool, platform):
    """Tip, end of the spindle and joints of the platform in W, mm: `position` is the control's, whose Z contains the
    length `tool`; `platform` holds the joints from the tip of a tool of length zero."""
    tip = (position[0], position[1], position[2] - tool)

    def placed(v):
        return tuple(t + r for t, r in zip(tip, turned(position[3:6], (v[0], v[1], v[2] + tool))))

    return tip, placed((0, 0, 0)), [placed(joint) for joint in platform]


class View:
    """Parallel projection of W onto a canvas, about the middle of the machine."""

    def __init__(self, canvas, middle, reach):
        self.canvas, self.middle, self.scale = canvas, middle, 0.42 * SIZE / reach
        self.about_z, self.about_x = math.radians(25), math.radians(15)
        self.grip = (0, 0)
        canvas.bind("<Button-1>", self.take)
        canvas.bind("<B1-Motion>", self.turn)
        canvas.bind("<Button-4>", lambda event: self.zoom(1.1))
        canvas.bind("<Button-5>", lambda event: self.zoom(1 / 1.1))

    def take(self, event):
        self.grip = (event.x, event.y)

    def turn(self, event):
        self.about_z += 0.01 * (event.x - self.grip[0])
        self.about_x += 0.01 * (event.y - self.grip[1])
        self.take(event)

    def zoom(self, factor):
        self.scale *= factor

    def at(self, point):
        x, y, z = (p - m for p, m in zip(point, self.middle))
        x, y = math.cos(self.about_z) * x - math.sin(self.about_z) * y, math.sin(self.about_z) * x + math.cos(self.about_z) * y
        z = math.cos(self.about_x) * z + math.sin(self.about_x) * y
        return SIZE / 2 + self.scale * x, SIZE / 2 - self.scale * z

    def ring(self, joints, colour):
        self.canvas.create_polygon([c for joint in joints for c in self.at(joint)], outline=colour, fill="", width=3)

    def line(self, a, b, colour, width):
        self.canvas.create_line(*self.at(a), *self.at(b), fill=colour, width=width, capstyle="round")

    def draw(self, base, tip, spindle, platform):
        self.canvas.delete("all")
        self.ring(base, "#555")
        for foot, joint in zip(base, platform):
            self.line(foot, joint, "#1f5fa8", 6)
        self.ring(platform, "#c0392b")
        middle = tuple(sum(c) / len(platform) for c in zip(*platform))
        self.line(middle, spindle, "#c0392b", 8)
        self.line(spindle, tip, "#222", 4)


def main():
    import tkinter

    import hal
    import linuxcnc

    component = hal.component("hexapod-view")  # ends with the others
    component.ready()

    def joints(of):
        return [tuple(hal.get_value(f"genhexkins.{of}.{j}.{axis}") for axis in "xyz") for j in STRUTS]

    base, platform = joints("base"), joints("platform")
    status = linuxcnc.stat()
    window = tkinter.Tk()
    window.title("hexapod")
    window.geometry("-20+20")  # beside AXIS, which opens at the left
    canvas = tkinter.Canvas(window, width=SIZE, height=SIZE, background="white")
    canvas.pack()
    status.poll()
    reach = max(math.dist(foot, (0, 0, foot[2])) for foot in base)
    view = View(canvas, (0, 0, (base[0][2] + status.position[2]) / 2), reach)

    def show():
        try:
            status.poll()
        except linuxcnc.error:  # the control has ended
            window.destroy()
            return
        view.draw(base, *stand(status.actual_position, status.tool_offset[2], platform))
        window.after(40, show)

    show()
    window.mainloop()


if __name__ == "__main__":
    main()
