% TRIALGATES  What in a trial run no powder does, and which slip makes it.
%
% CALL: NOTES = trialGates (RECORD, TARGETS, FOLDER, GRAINS)
%
%   RECORD   of the run, see newRecord; status 'ok'
%   TARGETS  1 x t struct array of the case, of this model: name, value, index
%   FOLDER   of the model (text)
%   GRAINS   struct of grainsOfRun: made, overlap, moving (NaN: not known)
%   NOTES    1 x n cell of sentences
%
% Bands, wide enough for any free-flowing or cohesive bulk, so that a note means a
% slip of the input:
%   slope of a heap    3 to 66 deg: the last class of USP <1174> begins at 66
%   surface of a drum  up to 75 deg
%   packing            0.45 to 0.67 of the volume: spheres 0.55 (Onoda and Liniger
%                      1990) to 0.64 (Scott and Kilgour 1969), walls below, several
%                      sizes above
%   mass               what was measured is not more than what is filled in
%   grains             as many as were asked for, and some left at the end; 100 at least
%                      where an angle or a density is read
%   overlap            8 % of a diameter at the end, as readChecks has it for the rigs
%   rest               where a heap or a packing is read, a tenth of the grains may be
%                      faster than after a fall of their radius
% and those of inputGates, with results and output_checks.csv by their names. Overlap,
% rest and lost grains of the toolbox's rigs are judged before (readChecks): such a run
% has failed.
%
% See also: sayCheck, unitRatio

function notes = trialGates (record, targets, folder, grains)
  info = resultInfo (folder);
  known = {};
  if ~isempty (info)                     % a model without results.csv
    known = {info.name};
  end
  values = headDefaults (fullfile (record.folder, 'data.head'));
  checks = struct ();
  if isfile (fullfile (record.folder, 'output_checks.csv'))
    checks = readChecks (record.folder);
  end
  notes = cell (1, 0);
  named = struct ();
  for T = targets
    result = record.results(T.index);
    k = find (strcmp (known, T.name), 1);
    if ~isempty (k)
      notes = [notes, ofResult(info(k), result, T.value, values, checks)];
      if isvarname (T.name)
        named.(T.name) = result;
      end
    end
  end
  notes = [notes, atEnd(grains, info), ...
           inputGates(folder, mergeFields (mergeFields (values, checks), named))];
end

% Of the grains at the end of the run.
function notes = atEnd (grains, info)
  notes = cell (1, 0);
  if grains.overlap > 0.08
    notes{end + 1} = sprintf (['two grains overlap by %.2g diameters at the end (0.08 at ' ...
                               'most). Are the grains too soft (Young''s modulus in ' ...
                               'MPa), the time step too long, or grains made inside ' ...
                               'others?'], grains.overlap);
  end
  isBulk = ~isempty (info) && any (ismember ({info.kind}, {'coneAngle', 'angle', ...
                                                           'angleFalling', 'density'}));
  if isBulk && givenField (grains, 'made', NaN) < 100
    notes{end + 1} = sprintf (['%d grains are few for an angle or a density: is the radius ' ...
                               'of a grain its diameter?'], grains.made);
  end
  isStill = ~isempty (info) && any (ismember ({info.kind}, {'coneAngle', 'density'}));
  if isStill && grains.moving > 0.1
    notes{end + 1} = sprintf (['%.0f %% of the grains still move at the end, where a heap ' ...
                               'or a packing is read: let it run longer.'], ...
                              100 * grains.moving);
  end
end

% Of one result, by its kind; an angle of a script of one's own has none.
function notes = ofResult (info, result, measured, values, checks)
  notes = cell (1, 0);
  kind = info.kind;
  if isempty (kind) && any (strcmp (info.unit, {'deg', 'degree'}))
    kind = 'ownAngle';
  end
  tops = struct ('coneAngle', 66, 'angleFalling', 66, 'ownAngle', 75, 'angle', 75);
  if isfield (tops, kind)
    notes = ofAngle (info.name, kind, result, tops.(kind));
  elseif strcmp (kind, 'density') && isfield (values, 'densityP')
    notes = [ofPacking(info.name, result / values.densityP, 'simulated', values), ...
             ofPacking(info.name, measured / values.densityP, 'measured', values)];
  elseif strcmp (kind, 'mass') && measured > 1.02 * givenField (checks, 'massStart', Inf)
    notes = {sprintf(['%s: measured %.3g %s, more than the %.3g %s that the run ' ...
                      'fills in. Is the density of a grain that of the bulk ' ...
                      '(a grain has about 1.7 times as much), or the filling ' ...
                      'smaller than yours?'], info.name, measured, info.unit, ...
                     checks.massStart, info.unit)};
  end
end

function notes = ofAngle (name, kind, value, top)
  notes = cell (1, 0);
  if abs (value) > top
    notes = {sprintf(['%s: %.3g deg, steeper than any heap of powder (%g deg). Too ' ...
                      'few or too large grains for the rig: is the radius of a ' ...
                      'grain its diameter?'], name, value, top)};
  elseif strcmp (kind, 'coneAngle') && value < 3
    notes = {sprintf(['%s: %.3g deg, no heap at all. Grains without friction, or ' ...
                      'hardly any left?'], name, value)};
  end
end

function notes = ofPacking (name, share, which, values)
  notes = cell (1, 0);
  if share > 0.67 || share < 0.45
    slip = merge (share < 0.45, ...
                  'is the bulk density in other units, or the grain hollow', ...
                  'is the density of a grain that of the bulk');
    notes = {sprintf(['%s: %s, it fills %.2g of the volume with grains of %g kg/m3, ' ...
                      'where grains fill 0.5 to 0.67: %s?'], name, which, share, ...
                     values.densityP, slip)};
  end
end

%!shared folder, put, record, T, still
%! still = struct ('overlap', NaN, 'moving', 0.02);
%! [folder, put] = emptyFolder ();
%! put ('results.csv', ["name,kind,unit,series,at,text\nslope,coneAngle,deg,,,x\n", ...
%!                      "mass,mass,kg,,,x\nbulk,density,kg/m3,,,x\nmine,,deg,,,x\n"]);
%! put ('data.head', "variable densityP equal 1200\nvariable radiusP equal 0.002\n");
%! record = struct ('folder', folder, 'results', [30, 0.01, 660, 40]);
%! T = struct ('name', {'slope', 'mass', 'bulk', 'mine'}, 'index', {1, 2, 3, 4}, ...
%!             'value', {31, 0.011, 650, NaN});
%!function of (notes, parts)
%!  assert (numel (notes) == numel (parts), '%s', strjoin (notes, "\n"));
%!  for k = 1:numel (parts)
%!    assert (! isempty (regexp (notes{k}, parts{k})), '%s', notes{k});
%!  end
%!endfunction
%!test
%! of (trialGates (record, T, folder, still), {});
%! record.results = [82, 0.01, 660, -80];
%! of (trialGates (record, T, folder, still), {'^slope: 82 deg, .* diameter', 'mine: -80'});
%! record.results = [2, 0.01, 660, 0.5];
%! of (trialGates (record, T, folder, still), {'no heap at all'});
%! record.results = [30, 0.01, 660, 40];
%!test
%! put ('data.head', "variable densityP equal 690\n");
%! put ('output_checks.csv', ["spheresStart,10\nspheresOut,4\nspheresEnd,6\nsettled,1\n", ...
%!                            "overlapMax,0.02\nmassStart,0.0105\n"]);
%! of (trialGates (record, T, folder, still), {'mass: measured 0.011 kg, more than the 0.0105', ...
%!     'bulk: simulated, .*0.96.*690 kg/m3.*that of the bulk', 'bulk: meas'});
%! unlink (fullfile (folder, 'output_checks.csv'));
%! put ('data.head', "variable densityP equal 1200\nvariable radiusP equal 0.002\n");
%!test
%! of (trialGates (record, T, folder, struct ('overlap', 0.2, 'moving', 0.5)), ...
%!     {'overlap by 0.2 diameters.* MPa', '^50 % of the grains still move'});
%! of (trialGates (record, T, folder, setfield (still, 'made', 50)), {'^50 grains are few'});
%!test
%! mkdir (fullfile (folder, 'sample'));
%! put ('sample/gates.csv', ["condition,says\n30 * radiusP > slope / 100,wide\n", ...
%!                           "radiusP < slope,right\nnoName > 2,unknown\n"]);
%! of (trialGates (record, T, folder, still), {'wide'});
%!test
%! % the gates of the toolbox's rigs read, and hold for their samples
%! root = fileparts (fileparts (which ('startToolbox')));
%! for file = glob (fullfile (root, 'DEMmodels', '*', 'sample', 'gates.csv'))'
%!   bench = fileparts (fileparts (file{1}));
%!   values = headDefaults (fullfile (bench, 'data.head'));
%!   values.massStart = 1;
%!   table = regexp (fileread (fullfile (bench, 'sample', 'expected.csv')), ...
%!                   '(\w+),(\S+)', 'tokens');
%!   for pair = table
%!     values.(pair{1}{1}) = str2double (pair{1}{2});
%!   end
%!   [~, cells] = readCsvTable (file{1});
%!   for row = cells'
%!     [rule, fault] = readRule (row{1}, {}, values);
%!     assert (fault, '');
%!     assert (rule (zeros (1, 0)), '%s', row{1});
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
