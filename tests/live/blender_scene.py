"""A subdivided head, run by Blender, turned for twelve frames."""
import bpy

bpy.context.preferences.view.show_splash = False
bpy.ops.mesh.primitive_monkey_add(size=4)
head = bpy.context.object
head.modifiers.new("subdivision", "SUBSURF").levels = 3
turns = 0


def turn():
    global turns
    turns += 1
    head.rotation_euler[2] = 0.05 * turns
    return 0.15 if turns < 12 else None


bpy.app.timers.register(turn, first_interval=2)
