% DENSITYNOTES  Measured bulk densities that no packing of the grains can have.
%
% CALL: NOTES = densityNotes (CASE)
%
%   CASE   see newCase: models, targets, names, limits, modelVars
%   NOTES  1 x n cell of sentences without a full stop
%
% Of a result of the kind density (resultInfo) in kg/m3, where the density of a grain,
% densityP, is known. Equal spheres fill 0.74 of the volume at most. What a run does with
% it is judged by trialGates, which is stricter.

function notes = densityNotes (Case)
  notes = cell (1, 0);
  for k = 1:numel (Case.models)
    info = resultInfo (Case.models(k).folder);
    grain = grainDensity (Case, Case.models(k).folder);
    if isempty (info)
      continue
    end
    isBulk = strcmp ({info.kind}, 'density') & strcmp ({info.unit}, 'kg/m3');
    for T = Case.targets([Case.targets.model] == k)
      isIt = strcmp ({info.name}, T.name);
      if isempty (T.result)              % in the order of getResults
        isIt = 1:numel (info) == T.index;
      end
      if any (isIt & isBulk) && T.value > 0.74 * grain
        notes{end + 1} = sprintf (['%s: measured, %.4g kg/m3 are %.2g of the density of a ' ...
                                   'grain (%.4g kg/m3), and grains fill 0.5 to 0.67 of ' ...
                                   'the volume: is one of them given for the other'], ...
                                  T.name, T.value, T.value / grain, grain);
      end
    end
  end
end

% The largest that the case allows; NaN: not known.
function grain = grainDensity (Case, folder)
  grain = NaN;
  head = fullfile (folder, 'data.head');
  if isfile (head)
    grain = givenField (headDefaults (head), 'densityP', NaN);
  end
  grain = givenField (Case.modelVars, 'densityP', grain);
  isFree = strcmp (Case.names, 'densityP');
  if any (isFree)
    grain = Case.limits(2, isFree);
  end
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'data.head'), "variable densityP equal 2500\n");
%! writeAtomic (fullfile (folder, 'results.csv'), ["name,kind,unit,series,at,text\n", ...
%!              "bulk,density,kg/m3,,,x\nmass,mass,kg,,,x\n"]);
%! Case = struct ('models', struct ('folder', folder), 'names', {{'mu'}}, ...
%!                'limits', [0; 1], 'modelVars', struct ());
%! Case.targets = struct ('model', 1, 'name', {'bulk', 'mass'}, 'value', {2500, 9000}, ...
%!                        'index', {1, 2}, 'result', {'bulk', 'mass'});
%! notes = densityNotes (Case);
%! assert (numel (notes), 1);
%! assert (strncmp (notes{1}, 'bulk: measured, 2500 kg/m3 are 1 of the density', 47));
%! [Case.targets.name, Case.targets.result] = deal ('M_1', 'M_2', '', '');
%! assert (strncmp (densityNotes (Case){1}, 'M_1: measured, 2500', 19));
%! Case.targets(1).value = 1500;
%! assert (isempty (densityNotes (Case)));
%! Case.modelVars.densityP = 1600;
%! assert (numel (densityNotes (Case)), 1);
%! Case.names = {'densityP'};
%! Case.limits = [1000; 3000];
%! assert (isempty (densityNotes (Case)));
%! Case.models.folder = '';
%! assert (isempty (densityNotes (Case)));

% SPDX-License-Identifier: GPL-3.0-only
