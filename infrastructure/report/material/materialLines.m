% MATERIALLINES  Values of a material as lines of a DEM program.
%
% CALL: TEXT = materialLines (PROGRAM, LIST)
% CALL: PROGRAMS = materialLines ()
%
%   PROGRAM   'liggghts', 'lammps', 'yade' or 'table' (property, value, unit)
%   LIST      of materialValues
%   TEXT      lines, without remarks of the case; '' where LIST has no name of a material
%             (a script with names of its own). LIGGGHTS gets no line of question marks
%   PROGRAMS  1 x n cell of the programs
%
% Contacts are those of Hertz and Mindlin with rolling resistance in all of them, but
% programs differ in how they damp and in what a rolling coefficient means: the lines
% give the limit of the torque that LIGGGHTS (EPSD2) has, coefficient x reduced
% radius x normal force. The stiffness of rolling is that of EPSD2, k_t R^2, at an
% overlap of 1 % of a diameter. A value that is not known is a question mark.
%
% Sources: documentation of pair_style granular (LAMMPS 2021), of
% Ip2_FrictMat_FrictMat_MindlinPhys (YADE 2022).
%
% Errors: DEcalioc:materialLines:unknownName
%
% See also: materialValues, sayExport

function text = materialLines (program, list)
  makers = struct ('liggghts', @liggghts, 'lammps', @lammps, 'yade', @yade, ...
                   'table', @namedTable);
  if nargin == 0
    text = fieldnames (makers)';
    return
  end
  if ~isfield (makers, program)
    error ('DEcalioc:materialLines:unknownName', ...
           'there are lines for %s, got ''%s''. Name one of them.', ...
           strjoin (fieldnames (makers)', ', '), program);
  end
  values = cell2struct ({list.value}', {list.name}', 1);
  isUsual = ~cellfun (@isempty, regexp ({list.name}, '^[a-z]\w*(PP|PW|P|W)$', 'once'));
  if ~any (isUsual)
    text = '';
    return
  end
  text = strjoin ([makers.(program)(@(name) numberOf (values, name), values), {''}], "\n");
end

function text = numberOf (values, name)
  text = '?';
  if isfield (values, name)
    text = sprintf ('%.6g', values.(name));
  end
end

function lines = liggghts (v, ~)
  pair = @(word, name) sprintf (['fix %s all property/global %s peratomtypepair 2 ' ...
                                 '%s %s %s %s'], word{:}, v([name, 'PP']), ...
                                v([name, 'PW']), v([name, 'PW']), v([name, 'PW']));
  one = @(word, name) sprintf ('fix %s all property/global %s peratomtype %s %s', ...
                               word{:}, v([name, 'P']), v([name, 'W']));
  lines = {'# type 1: grains, type 2: walls', ...
           one({'m1', 'youngsModulus'}, 'youngsModulus'), ...
           one({'m2', 'poissonsRatio'}, 'poissonsRatio'), ...
           pair({'m3', 'coefficientRestitution'}, 'coefRestitution'), ...
           pair({'m4', 'coefficientFriction'}, 'coefFriction'), ...
           pair({'m5', 'coefficientRollingFriction'}, 'coefRollingFriction'), ...
           'pair_style gran model hertz tangential history rolling_friction epsd2', ...
           'pair_coeff * *', ...
           ['# density of the grains ', v('densityP'), ' kg/m3, radius ', v('radiusP'), ' m']};
  % of what nothing is known, no line
  isOpen = ~cellfun (@isempty, regexp (lines, 'peratomtype(pair 2)?( \?)+$', 'once'));
  lines = lines(~isOpen);
end

function lines = lammps (v, values)
  contact = @(ends) sprintf (['hertz/material %s %s %s tangential mindlin NULL 1.0 %s ' ...
                              'rolling sds %s 0.0 %s damping tsuji'], ...
                             v('youngsModulusP'), v(['coefRestitution', ends]), ...
                             v('poissonsRatioP'), v(['coefFriction', ends]), ...
                             rollingForce (values), v(['coefRollingFriction', ends]));
  lines = {'# units si, atom_style sphere; type 1: grains', ...
           ['set type 1 density ', v('densityP')], ...
           'pair_style granular', ['pair_coeff * * ', contact('PP')], ...
           ['# a wall, here z = 0: ', ...
            'fix wall all wall/gran granular ', contact('PW'), ' zplane 0 NULL']};
end

function lines = yade (v, values)
  half = '?';
  if isfield (values, 'coefRollingFrictionPP')
    half = sprintf ('%.6g', values.coefRollingFrictionPP / 2);
  end
  lines = {'from math import atan', ...
           ['grains = O.materials.append(FrictMat(young=', v('youngsModulusP'), ...
            ', poisson=', v('poissonsRatioP'), ', density=', v('densityP'), ...
            ', frictionAngle=atan(', v('coefFrictionPP'), '), label=''grains''))'], ...
           ['walls = O.materials.append(FrictMat(young=', v('youngsModulusW'), ...
            ', poisson=', v('poissonsRatioW'), ', density=', v('densityP'), ...
            ', frictionAngle=atan(', v('coefFrictionPW'), '), label=''walls''))'], ...
           ['physics = Ip2_FrictMat_FrictMat_MindlinPhys(eta=', half, ', krot=', ...
            rollingTorque(values), ', en=MatchMaker(matches=((grains, grains, ', ...
            v('coefRestitutionPP'), '), (grains, walls, ', v('coefRestitutionPW'), ...
            ')), algo=''val'', val=', v('coefRestitutionPW'), '))'], ...
           'law = Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)'};
end

function lines = namedTable (v, values)
  shear = @(ends) '?';
  if all (isfield (values, {'youngsModulusP', 'poissonsRatioP'}))
    shear = @(ends) sprintf ('%.6g', values.youngsModulusP / ...
                             (2 * (1 + values.poissonsRatioP)));
  end
  lines = {'property,grains,grains on grains,grains on walls,unit', ...
           ['Solids density,', v('densityP'), ',,,kg/m3'], ...
           ['Particle radius,', v('radiusP'), ',,,m'], ...
           ['Young''s modulus,', v('youngsModulusP'), ',,,Pa'], ...
           ['Shear modulus,', shear(''), ',,,Pa'], ...
           ['Poisson''s ratio,', v('poissonsRatioP'), ',,,'], ...
           ['Coefficient of restitution,,', v('coefRestitutionPP'), ',', ...
            v('coefRestitutionPW'), ','], ...
           ['Coefficient of static friction,,', v('coefFrictionPP'), ',', ...
            v('coefFrictionPW'), ','], ...
           ['Coefficient of rolling friction,,', v('coefRollingFrictionPP'), ',', ...
            v('coefRollingFrictionPW'), ',']};
end

% k_t of Mindlin, 8 G* sqrt (R* overlap), of two like grains; N/m.
function text = rollingForce (values)
  text = '?';
  if all (isfield (values, {'youngsModulusP', 'poissonsRatioP', 'radiusP'}))
    text = sprintf ('%.6g', tangentialStiffness (values));
  end
end

% k_t R*^2, N m/rad.
function text = rollingTorque (values)
  text = '?';
  if all (isfield (values, {'youngsModulusP', 'poissonsRatioP', 'radiusP'}))
    text = sprintf ('%.6g', tangentialStiffness (values) * values.radiusP^2 / 4);
  end
end

function k = tangentialStiffness (values)
  nu = values.poissonsRatioP;
  shear = values.youngsModulusP / (4 * (1 + nu) * (2 - nu));
  k = 8 * shear * sqrt (values.radiusP / 2 * 0.02 * values.radiusP);
end

%!function list = grains ()
%!  v = struct ('densityP', 2500, 'radiusP', 0.002, 'youngsModulusP', 5e6, ...
%!              'poissonsRatioP', 0.3, 'youngsModulusW', 2e11, 'poissonsRatioW', 0.3, ...
%!              'coefRestitutionPP', 0.6, 'coefRestitutionPW', 0.7, ...
%!              'coefFrictionPP', 0.5, 'coefFrictionPW', 0.4, ...
%!              'coefRollingFrictionPP', 0.1, 'coefRollingFrictionPW', 0.05);
%!  list = struct ('name', fieldnames (v)', 'value', struct2cell (v)');
%!endfunction
%!test
%! % every number of the material comes in, nothing is open
%! for program = setdiff (materialLines (), {'table'})
%!   text = materialLines (program{1}, grains ());
%!   for number = {'2500', '0.6', '0.5'}
%!     assert (~isempty (strfind (text, number{1})), [program{1}, number{1}]);
%!   end
%!   assert (isempty (strfind (text, '?')), text);
%! end
%!test
%! % a value that is not known is not made up
%! list = grains ();
%! list = list(~strcmp ({list.name}, 'youngsModulusP'));
%! assert (~isempty (strfind (materialLines ('lammps', list), 'hertz/material ? 0.6')));
%! assert (~isempty (strfind (materialLines ('table', list), 'Shear modulus,?,')));
%!test
%! % a script with names of its own; one that knows its friction alone
%! own = struct ('name', {'mu', 'roll'}, 'value', {0.4, 0.1});
%! assert (materialLines ('liggghts', own), '');
%! list = grains ();
%! text = materialLines ('liggghts', list(strcmp ({list.name}, 'coefFrictionPP')));
%! assert (numel (strfind (text, 'fix ')), 1);
%! assert (! isempty (strfind (text, '2 0.5 ? ? ?')), text);
%!testif ; ~isempty (file_in_path (getenv ('PATH'), 'lmp'))
%! % LAMMPS takes them: a grain rests on another
%! file = [tempname(), '.in'];
%! lines = strsplit (materialLines ('lammps', grains ()), "\n");
%! wall = regexprep (lines{5}, '^# [^:]*: ', '');
%! writeAtomic (file, strjoin ({'units si', 'atom_style sphere', 'boundary p p f', ...
%!   'newton off', 'region box block 0 0.02 0 0.02 0 0.05', 'create_box 1 box', ...
%!   'create_atoms 1 single 0.01 0.01 0.01', 'create_atoms 1 single 0.01 0.0138 0.01', ...
%!   'set type 1 diameter 0.004', lines{2:4}, 'comm_modify vel yes', ...
%!   'timestep 1e-6', 'fix move all nve/sphere', wall, 'run 100', ''}, "\n"));
%! [status, out] = system (['cd ', shellQuote(fileparts (file)), ...
%!                          ' && lmp -log none -in ', shellQuote(file), ' 2>&1']);
%! assert (status == 0 && ~isempty (strfind (out, 'Total wall time')), out);
%!testif ; ~isempty (file_in_path (getenv ('PATH'), 'yade'))
%! % and YADE
%! file = [tempname(), '.py'];
%! writeAtomic (file, ["from yade import *\n", materialLines('yade', grains ()), ...
%!                     "print ('taken', physics.eta, O.materials[grains].density)\n", ...
%!                     "import os\nos._exit (0)\n"]);
%! [~, out] = system (['timeout 60 yade -n -x ', shellQuote(file), ' 2>&1']);
%! assert (~isempty (strfind (out, 'taken 0.05 2500')), out);
%!error id=DEcalioc:materialLines:unknownName materialLines ('edem', struct ([]))

% SPDX-License-Identifier: GPL-3.0-only
