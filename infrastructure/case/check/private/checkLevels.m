% CHECKLEVELS  Checks the levels of Input.coarse.
%
% CALL: [P, NAMES, FIELDS] = checkLevels (RAW, N)
%
%   RAW     see checkCase
%   N       number of models
%   P       1 x n faults, see checkFault
%   NAMES   1 x v cell, variables of the levels, once each model has one; empty
%           with a fault in Input.coarse
%   FIELDS  1 x v cell, how the user writes each
%
% Input.coarse{k}: [] or a struct with the fields variable and levels (the last
% one counts). All models that have levels have as many; one variable has the
% same levels for all models that share it.

function [p, names, fields] = checkLevels (raw, n)
  [names, fields] = deal (cell (1, 0));
  coarse = givenField (raw.Input, 'coarse', {});
  [p, isGiven] = checkShape (coarse, n);
  if isempty (coarse) || ~isempty (p)
    return
  end
  given = [coarse{isGiven}];
  fields = arrayfun (@(k) sprintf ('Input.coarse{%d}.variable', k), ...
                     find (isGiven(:)'), 'UniformOutput', false);
  names = {given.variable};
  for k = 1:numel (given)
    p = [p, checkVariable(given(k), raw)];
    first = given(find (strcmp (names{k}, names), 1));
    if ~isequal (first.levels(:), given(k).levels(:))
      p(end + 1) = checkFault ('levelsDiffer', 'Input.coarse', ...
                               ['the same levels of ', names{k}, ...
                                ' for each model'], ...
                               describeValue (given(k).levels), ...
                               ['A variable is written into all models of ' ...
                                'a run.']);
    end
  end
  if ~isempty (given) && ...
     isequal (givenField (raw.optim, 'method', ''), 'published')
    p(end + 1) = checkFault ('levelMethod', 'optim.method', ...
                             'robust, where Input.coarse gives levels', ...
                             describeValue (raw.optim.method), ...
                             'Leave out optim.method or Input.coarse.');
  end
end

function [p, isGiven] = checkShape (coarse, n)
  cure = ['Write Input.coarse{1} = struct (''variable'', ''scaleP'', ' ...
          '''levels'', [1.6, 1.25, 1]); or leave it out.'];
  p = checkFault ();
  isGiven = [];
  if ~iscell (coarse)
    p = checkFault ('badCoarse', 'Input.coarse', ...
                    'a cell, one element a model', describeValue (coarse), cure);
    return
  end
  if n > 0 && numel (coarse) > n
    p = checkFault ('coarseCount', 'Input.coarse', ...
                    sprintf ('at most %d element(s), one a model', n), ...
                    sprintf ('%d elements', numel (coarse)), cure);
  end
  isGiven = ~cellfun (@(c) isKind ('nothing', c), coarse);
  for k = find (isGiven(:)')
    p = [p, checkOne(coarse{k}, sprintf ('Input.coarse{%d}', k), cure)];
  end
  counts = cellfun (@(c) numel (givenField (c, 'levels', [])), coarse(isGiven));
  if isempty (p) && any (counts ~= counts(1:min (1, end)))
    p = checkFault ('levelCount', 'Input.coarse', ...
                    'as many levels for each model that has some', ...
                    describeValue (counts), ...
                    'Give each model the same number of levels.');
  end
end

function p = checkOne (given, field, cure)
  if ~isKind ('struct', given) || ~isfield (given, 'variable') || ...
     ~isKind ('name', given.variable) || ~isfield (given, 'levels')
    p = checkFault ('badCoarse', field, ...
                    'a struct with the fields variable and levels', ...
                    describeValue (given), cure);
    return
  end
  p = checkFields (given, field, {'variable', 'levels'});
  levels = given.levels;
  if ~isKind ('vector', levels) || ~all (isfinite (levels)) || ...
     numel (levels) < 2 || ...
     abs (sum (sign (diff (levels)))) < numel (levels) - 1
    p(end + 1) = checkFault ('badLevels', [field, '.levels'], ...
                             'two and more numbers, rising or falling', ...
                             describeValue (levels), ...
                             ['Put the coarsest and cheapest first, the ' ...
                              'one that counts last.']);
  end
end

function p = checkVariable (given, raw)
  p = checkFault ();
  name = given.variable;
  last = given.levels(end);
  if iscell (raw.assign) && any (strcmp (name, raw.assign))
    p = checkFault ('levelAssigned', 'Input.coarse', ...
                    'a variable that is not in assign', name, ...
                    'A variable is either calibrated or a level.');
  elseif isfield (raw.modelVars, name) && ~isequal (raw.modelVars.(name), last)
    p = checkFault ('levelFixed', ['modelVars.', name], ...
                    sprintf ('the last level, %g', last), ...
                    describeValue (raw.modelVars.(name)), ...
                    'Take it out: the calibration is for the last level.');
  end
end

%!test
%! raw = struct ('modelVars', struct (), 'optim', struct (), 'assign', {{'a'}});
%! level = @(values) struct ('variable', 'scaleP', 'levels', values);
%! for good = {{}, {[], level([2, 1])}, {level([1; 2]), level([1, 2])}}
%!   raw.Input = struct ('coarse', good);
%!   [p, names] = checkLevels (raw, 2);
%!   assert ({isempty(p), numel(names)}, {true, numel([good{1}{:}])});
%! end
%! for bad = {1, [1, 2, 1], [1, NaN], 'a', [1, 1]}
%!   raw.Input.coarse = {level(bad{1})};
%!   assert (checkLevels (raw, 2).id, 'DEcalioc:checkCase:badLevels');
%! end

% SPDX-License-Identifier: GPL-3.0-only
