# YadeHeap: the heap of DEMmodels/Heap in YADE. A tube filled with grains is
# lifted off a round plate; a heap stays, what rolls over its edge falls out.
#
# Steps: 1 fill the tube, 2 settle, 3 lift the tube, 4 wait for rest
# -> heap.dump.
# Run it with "bash runscript".
import math
import sys

from yade import O, utils

sys.dont_write_bytecode = True    # the folder of a model stays as it is
sys.path.insert(0, '.')
import grains

v = grains.derive(grains.readHead())
plate, tube = v['plateRadius'], v['tubeRadius']
side, tubeTop, facets = plate + 0.015, 0.1, 24
grains.addMaterials(v)


def corner(radius, k, z):
    angle = 2 * math.pi * k / facets
    return (radius * math.cos(angle), radius * math.sin(angle), z)


def facet(*corners):
    return grains.addFixed(utils.facet(corners, fixed=True, material='wall'))


# the plate is rough: glued grains on a disc
step = 8 / 3 * v['radiusP']
n = int(plate / step)
grains.addGlued(v, [(i * step, j * step, 0) for i in range(-n, n + 1)
                    for j in range(-n, n + 1)
                    if math.hypot(i, j) * step <= plate - v['radiusP']])
tubeIds = []
for k in range(facets):
    facet((0, 0, 0), corner(plate, k, 0), corner(plate, k + 1, 0))
    a, b = corner(tube, k, 0), corner(tube, k + 1, 0)
    c, d = corner(tube, k + 1, tubeTop), corner(tube, k, tubeTop)
    tubeIds += [facet(a, b, c), facet(a, c, d)]

# --- 1 fill ----------------------------------------------------------------
solid = v['heapSolid'] * v['fillFactor']
clear = 0.99 * tube
fillTop = 3.6 * solid / (math.pi * clear ** 2) + v['radiusP']


def fits(point, radius):
    return (math.hypot(point[0], point[1]) <= clear - radius and
            v['radiusP'] + radius <= point[2] <= fillTop - radius)


grains.fill(v, round(solid / v['volumeG']),
            lambda random: random.uniform((-clear, -clear, 0),
                                          (clear, clear, fillTop)), fits)
watch = grains.Watch(v, lambda pos: pos[2] < -0.03 or
                     max(abs(pos[0]), abs(pos[1])) > side)
grains.addEngines(v, [('watch.look()', v['nLook'], '')])

# --- 2 settle --------------------------------------------------------------
settled = watch.untilRest()
spheresSettled = len(grains.looseGrains())

# --- 3 lift ----------------------------------------------------------------
for k in tubeIds:
    O.bodies[k].state.vel = (0, 0, v['liftSpeed'])
watch.run(v['liftHeight'] / v['liftSpeed'])
for k in tubeIds:
    O.bodies[k].state.vel = (0, 0, 0)

# --- 4 wait for rest -------------------------------------------------------
settled = watch.untilRest() and settled
grains.dump('heap.dump')
grains.writeChecks(watch, settled, watch.start - len(grains.looseGrains()),
                   dict(spheresSettled=spheresSettled, plateRadius=plate))
print('RUN COMPLETE', flush=True)
