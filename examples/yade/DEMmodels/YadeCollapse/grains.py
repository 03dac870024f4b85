"""What the YADE benches share: the variables of data.head, contact law, fill,
rest, dumps and checks. The benches of LIGGGHTS do the same in
infrastructure/effects/liggghts/. SI units throughout."""
import math
import re

import numpy
from yade import (O, Bo1_Box_Aabb, Bo1_Facet_Aabb, Bo1_Sphere_Aabb,
                  DragEngine, ForceResetter, FrictMat, Ig2_Box_Sphere_ScGeom,
                  Ig2_Facet_Sphere_ScGeom, Ig2_Sphere_Sphere_ScGeom,
                  InsertionSortCollider, InteractionLoop,
                  Ip2_FrictMat_FrictMat_MindlinPhys,
                  Law2_ScGeom_MindlinPhys_Mindlin, LinearDragEngine,
                  MatchMaker, NewtonIntegrator, PyRunner, utils)

GRAVITY = 9.81
LOOSE, FIXED = 1, 3      # masks: fixed bodies do not see one another


def readHead(file='data.head'):
    """Variables of data.head; the last line that names one counts."""
    line = re.compile(r'^\s*variable\s+(\w+)\s+equal\s+([^#\s]+)')
    found = [line.match(text) for text in open(file)]
    return {m.group(1): float(m.group(2)) for m in found if m}


def derive(v):
    """What follows from variables and effects, as effects/derived.inc does."""
    s2 = v['sizeSpread'] ** 2
    factor = v['sizeFactor'] * (1 + s2) / (1 + 3 * s2)
    spread = math.sqrt(2) * v['sizeSpread']
    v['radiusG'] = v['radiusP'] * factor
    v['radii'] = [v['radiusG'] * f for f in (1 - spread, 1, 1 + spread)]
    v['volumeG'] = 4 / 3 * math.pi * v['radiusG'] ** 3 * (1 + 3 * s2)
    v['densityG'] = v['densityP'] * v['densityFactor']
    v['massG'] = v['volumeG'] * v['densityG']
    v['youngG'] = v['youngsModulusP'] * v['stiffnessFactor']
    shear = v['youngsModulusP'] / (2 * (1 + v['poissonsRatioP']))
    rayleigh = (math.pi * v['radiusP'] * math.sqrt(v['densityP'] / shear)
                / (0.1631 * v['poissonsRatioP'] + 0.8766))
    step = v['SIMTS'] if v['SIMTS'] > 0 else v['percentRayleigh'] * rayleigh
    v['timeStep'] = (step * factor * (1 - spread)
                     * math.sqrt(v['densityFactor'] / v['stiffnessFactor'])
                     / (1 + max(v['dampingFactor'] - 1, 0) / 3))
    v['nLook'] = math.ceil(0.02 / v['timeStep'])
    return v


def addMaterials(v):
    """Materials 'grain' (0) and 'wall' (1)."""
    O.materials.append(FrictMat(
        young=v['youngG'], poisson=v['poissonsRatioP'], density=v['densityG'],
        frictionAngle=math.atan(v['coefFrictionPP']), label='grain'))
    O.materials.append(FrictMat(
        young=v['youngsModulusW'], poisson=v['poissonsRatioW'],
        density=v['densityP'], label='wall',
        frictionAngle=math.atan(v['coefFrictionPW'])))


def pairs(grains, walls):
    """A value for contacts between grains, another for those with walls."""
    return MatchMaker(matches=((0, 0, grains), (0, 1, walls)), algo='val',
                      val=walls)


def addEngines(v, runners):
    """Contact law, drag, integrator, and what is called now and then."""
    # M_max = eta x r x F_n: with half the coefficient that of two grains is
    # rolling friction x r / 2 x F_n, the limit that EPSD2 of LIGGGHTS has
    eta = (v['coefRollingFrictionPP'] + v['rollingAdded']) / 2
    # stiffness of rolling = k_t r^2 / 4 at an overlap of 1 % of a diameter
    r = v['radiusG']
    shear = v['youngG'] / (2 * (1 + v['poissonsRatioP']))
    kt = 4 * shear / (2 - v['poissonsRatioP']) * math.sqrt(0.01 * r * r)
    damp = v['dampingFactor']
    physics = Ip2_FrictMat_FrictMat_MindlinPhys(
        gamma=v['surfaceEnergy'], eta=eta, krot=kt * r * r / 4,
        en=pairs(v['coefRestitutionPP'] ** damp,
                 v['coefRestitutionPW'] ** damp),
        frictAngle=pairs(math.atan(v['coefFrictionPP']),
                         math.atan(v['coefFrictionPW']
                                   * v['wallFrictionFactor'])))
    law = Law2_ScGeom_MindlinPhys_Mindlin(
        includeMoment=eta > 0, includeAdhesion=v['surfaceEnergy'] > 0)
    collider = InsertionSortCollider(
        [Bo1_Sphere_Aabb(), Bo1_Facet_Aabb(), Bo1_Box_Aabb()],
        verletDist=0.15 * v['radiusG'], allowBiggerThanPeriod=True,
        avoidSelfInteractionMask=2)
    tilt = math.radians(v['tiltAngle'])
    O.engines = [
        ForceResetter(), collider,
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(),
                         Ig2_Box_Sphere_ScGeom()], [physics], [law])]
    loose = [b.id for b in looseGrains()]
    if v['dragRate'] > 0:          # 6 pi nu r = mass x rate
        nu = v['massG'] * v['dragRate'] / (6 * math.pi * v['radiusG'])
        O.engines += [LinearDragEngine(nu=nu, ids=loose)]
    if v['dragDensity'] > 0:       # the drag coefficient times the density
        O.engines += [DragEngine(Rho=v['dragDensity'], Cd=1, ids=loose)]
    O.engines += [NewtonIntegrator(
        damping=0, gravity=(GRAVITY * math.sin(tilt), 0,
                            -GRAVITY * math.cos(tilt)))]
    O.engines += [PyRunner(command=command, iterPeriod=period, label=label)
                  for command, period, label in runners]
    O.dt = v['timeStep']


def addFixed(body):
    """Appends a wall, a facet or a glued grain that never moves."""
    body.mask = FIXED
    return O.bodies.append(body)


def addGlued(v, points):
    """A rough floor: fixed grains of radiusP, whatever the effects are."""
    for point in points:
        addFixed(utils.sphere(point, v['radiusP'], fixed=True,
                              material='wall'))


def sizes(v, count, random):
    """Radii: one, or three at the weights 1/4, 1/2, 1/4 by number."""
    if v['sizeSpread'] == 0:
        return numpy.full(count, v['radiusG'])
    return numpy.sort(random.choice(v['radii'], count,
                                    p=(0.25, 0.5, 0.25)))[::-1]


def fill(v, count, draw, isInside, period=None):
    """Puts spheres at random places, the largest first, none overlapping.

    draw (random) gives a point, isInside (point, radius) whether a sphere fits
    there; period is that along y."""
    random = numpy.random.RandomState(int(v['runSeed']))
    radii = sizes(v, count, random)
    places = numpy.zeros((count, 3))
    for k in range(count):
        for _ in range(20000):
            point = draw(random)
            gap = places[:k] - point
            if period:
                gap[:, 1] -= period * numpy.round(gap[:, 1] / period)
            clear = (gap ** 2).sum(1) >= (radii[:k] + radii[k]) ** 2
            if isInside(point, radii[k]) and clear.all():
                break
        else:
            raise RuntimeError('ERROR: grain %d found no place' % k)
        places[k] = point
    for point, radius in zip(places, radii):
        body = utils.sphere(point, radius, material='grain')
        body.mask = LOOSE
        O.bodies.append(body)


def looseGrains():
    """The grains that are not glued."""
    return [b for b in O.bodies if b.mask == LOOSE]


class Watch:
    """Looks every nLook steps: overlap, rest, grains that have left.

    Those are taken out, where hasLeft (position) says which they are."""

    def __init__(self, v, hasLeft=lambda position: False):
        self.v, self.hasLeft = v, hasLeft
        self.overlap, self.seconds = 0.0, 0.0
        self.start = len(looseGrains())
        self.mass = sum(b.state.mass for b in looseGrains())
        self.waits, self.looks, self.calm = False, 0, 0

    def look(self):
        for body in looseGrains():
            if self.hasLeft(body.state.pos):
                O.bodies.erase(body.id)
        depths = [i.geom.penetrationDepth for i in O.interactions]
        diameter = 2 * self.v['radiusP'] * self.v['sizeFactor']
        self.overlap = max([self.overlap] + [d / diameter for d in depths])
        self.looks += 1
        self.seconds += self.v['nLook'] * O.dt
        grains = [b.state for b in looseGrains()]
        energy = sum(s.mass * s.vel.squaredNorm() / 2 for s in grains)
        weight = sum(s.mass for s in grains) * GRAVITY * self.v['radiusP']
        isCalm = energy < self.v['restEnergy'] * weight
        self.calm = self.calm + 1 if isCalm else 0
        if self.waits and self.looks > 5 and self.calm > 1:
            self.rests = True
            O.pause()

    def run(self, seconds):
        """Runs so long. Without an end by rest."""
        self.begin(False, seconds)

    def untilRest(self):
        """Runs until the grains rest at two looks in a row, or restTime."""
        self.begin(True, self.v['restTime'])
        return self.rests

    def begin(self, waits, seconds):
        self.looks, self.calm, self.rests, self.waits = 0, 0, False, waits
        looks = math.ceil(seconds / (self.v['nLook'] * O.dt))
        O.run(looks * self.v['nLook'], True)


def dump(file, shift=(0, 0, 0), width=None):
    """The loose grains as a LIGGGHTS dump, which readDump takes."""
    grains = looseGrains()
    with open(file, 'w') as out:
        out.write('ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\n'
                  % (O.iter, len(grains)))
        out.write('ITEM: BOX BOUNDS\n-1 1\n-1 1\n-1 1\n')
        out.write('ITEM: ATOMS id x y z radius\n')
        for b in grains:
            x, y, z = [b.state.pos[k] - shift[k] for k in range(3)]
            if width:
                y %= width
            out.write('%d %.7g %.7g %.7g %.7g\n'
                      % (b.id, x, y, z, b.shape.radius))


def writeChecks(watch, settled, left, more):
    """output_checks.csv, by which readChecks judges the run."""
    checks = dict(spheresStart=watch.start, massStart=watch.mass,
                  spheresOut=left, spheresEnd=len(looseGrains()),
                  settled=int(settled), overlapMax=watch.overlap,
                  timeStep=O.dt, secondsRun=watch.seconds)
    checks.update(more)
    with open('output_checks.csv', 'w') as out:
        for name, value in checks.items():
            out.write('%s,%.15g\n' % (name, value))
