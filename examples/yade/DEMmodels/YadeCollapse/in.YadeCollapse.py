# YadeCollapse: the column collapse of DEMmodels/Collapse in YADE.
#
# Steps: 1 fill, 2 settle -> column.dump, 3 open the gate, 4 wait for rest
# -> spread.csv (mean position against time), deposit.dump.
# Run it with "bash runscript".
import math
import sys

import numpy
from yade import O, utils

sys.dont_write_bytecode = True    # the folder of a model stays as it is
sys.path.insert(0, '.')
import grains

v = grains.derive(grains.readHead())
length, width = v['columnLength'], v['columnWidth']
solid = v['columnSolid'] * v['fillFactor']
aspect = solid / (0.55 * length)
runway = (v['floorLength'] + max(3 * (aspect - 2.5), 0)) * length

# periodic along y; along x and z the cell is wider than the bench, which
# stands at a distance from its sides
edge = 0.02
O.periodic = True
O.cell.setBox(runway + 2 * edge, width, 5 * solid + 2 * edge)
grains.addMaterials(v)

# a rough floor: glued grains on a square lattice
step = width / v['glueColumns']
grains.addGlued(v, [(edge + i * step, j * step, edge)
                    for i in range(int(runway / step) + 1)
                    for j in range(int(v['glueColumns']))])


def block(x, z, sizeX, sizeZ):
    # a wall: much wider than a period along y, for grains that have crossed it
    half = (sizeX / 2, 3.4 * width, sizeZ / 2)
    centre = (edge + x + half[0], width / 2, edge + z + half[2])
    return grains.addFixed(utils.box(centre, half, fixed=True,
                                     material='wall'))


thick, high = 0.8 * edge, 5 * solid
block(0, -thick, runway, thick)                    # floor
block(-thick, 0, thick, high)                      # back
stop = block(runway, 0, thick, high)
gate = block(length, 0, thick, high)

# --- 1 fill ----------------------------------------------------------------
low = numpy.array([0, 0, v['radiusP']])
top = numpy.array([length, width, 4 * solid])
shift = numpy.array([edge, 0, edge])


def fits(point, radius):
    inside = point - shift
    return (radius <= inside[0] <= length - radius and
            low[2] + radius <= inside[2] <= top[2] - radius)


grains.fill(v, round(solid * length * width / v['volumeG']),
            lambda random: shift + random.uniform(low, top), fits, width)
watch = grains.Watch(v)
curve = []


def spread():
    x = [b.state.pos[0] - edge for b in grains.looseGrains()]
    curve.append((O.time - opened, sum(x) / len(x)))


grains.addEngines(v, [('watch.look()', v['nLook'], ''),
                      ('spread()', math.ceil(0.004 / v['timeStep']), 'flow')])
flow.dead = True

# --- 2 settle --------------------------------------------------------------
settled = watch.untilRest()
grains.dump('column.dump', shift, width)

# --- 3 open the gate, 4 wait for rest --------------------------------------
# moved into the stop: to erase a body may hang a periodic collider (2023.02a)
O.bodies[gate].state.pos = O.bodies[stop].state.pos
opened = O.time
flow.dead = False
settled = watch.untilRest() and settled
grains.dump('deposit.dump', shift, width)
with open('spread.csv', 'w') as out:
    out.write('time_s,meanX_m\n')
    for row in curve:
        out.write('%.9g,%.9g\n' % row)

lost = sum(not (edge / 2 < b.state.pos[0] < edge * 1.5 + runway and
                b.state.pos[2] > edge) for b in grains.looseGrains())
grains.writeChecks(watch, settled, 0,
                   dict(spheresEnd=watch.start - lost, columnLength=length,
                        columnWidth=width, runway=runway))
print('RUN COMPLETE', flush=True)
