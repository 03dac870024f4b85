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
% Input.coarse{k}: [] or a struct with the fields variable (a name) and levels
% (two and more different numbers, rising or falling; the last one counts). All
% models that have levels have as many. A level is no design variable; where
% modelVars names it, with the last level; one variable has the same levels for
% all models that share it; method 'published' knows no levels.
%
% Reasons: badCoarse coarseCount badLevels levelCount levelAssigned levelFixed
% levelsDiffer levelMethod

function [p, names, fields] = checkLevels (raw, n)
  [names, fields] = deal (cell (1, 0));
  p = checkFault ();
  if ~isstruct (raw.Input) || ~isfield (raw.Input, 'coarse') || ...
     checkIs ('nothing', raw.Input.coarse)
    return
  end
  coarse = raw.Input.coarse;
  p = checkShape (coarse, n);
  if ~isempty (p)
    return
  end
  isGiven = ~cellfun (@(c) checkIs ('nothing', c), coarse(:)');
  fields = arrayfun (@(k) sprintf ('Input.coarse{%d}.variable', k), ...
                     find (isGiven), 'UniformOutput', false);
  given = [coarse{isGiven}];
  names = {given.variable};
  for k = 1:numel (given)
    p = [p, checkVariable(given(k), raw)];
    first = given(find (strcmp (names{k}, names), 1));
    if ~isequal (first.levels(:), given(k).levels(:))
      p(end + 1) = checkFault ('levelsDiffer', 'Input.coarse', ...
                               ['the same levels of ', names{k}, ...
                                ' for each model'], ...
                               checkShow (given(k).levels), ...
                               ['A variable is written into all models of ' ...
                                'a run.']);
    end
  end
  if ~isempty (given) && isstruct (raw.optim) && ...
     isfield (raw.optim, 'method') && isequal (raw.optim.method, 'published')
    p(end + 1) = checkFault ('levelMethod', 'optim.method', ...
                             'robust, where Input.coarse gives levels', ...
                             checkShow (raw.optim.method), ...
                             'Leave out optim.method or Input.coarse.');
  end
end

function p = checkShape (coarse, n)
  cure = ['Write Input.coarse{1} = struct (''variable'', ''scaleP'', ' ...
          '''levels'', [1.6, 1.25, 1]); or leave it out.'];
  p = checkFault ();
  if ~iscell (coarse)
    p = checkFault ('badCoarse', 'Input.coarse', ...
                    'a cell, one element a model', checkShow (coarse), cure);
    return
  end
  if n > 0 && numel (coarse) > n
    p = checkFault ('coarseCount', 'Input.coarse', ...
                    sprintf ('at most %d element(s), one a model', n), ...
                    sprintf ('%d elements', numel (coarse)), cure);
  end
  counts = zeros (1, 0);
  for k = find (~cellfun (@(c) checkIs ('nothing', c), coarse(:)'))
    [q, counts(end + 1)] = checkOne (coarse{k}, k, cure);
    p = [p, q];
  end
  if isempty (p) && any (counts ~= counts(1:min (1, end)))
    p = checkFault ('levelCount', 'Input.coarse', ...
                    'as many levels for each model that has some', ...
                    checkShow (counts), ...
                    'Give each model the same number of levels.');
  end
end

function [p, n] = checkOne (given, k, cure)
  n = 0;
  field = sprintf ('Input.coarse{%d}', k);
  if ~checkIs ('struct', given) || ~isfield (given, 'variable') || ...
     ~checkIs ('name', given.variable) || ~isfield (given, 'levels')
    p = checkFault ('badCoarse', field, ...
                    'a struct with the fields variable and levels', ...
                    checkShow (given), cure);
    return
  end
  p = checkFields (given, field, {'variable', 'levels'});
  levels = given.levels;
  if checkIs ('vector', levels) && all (isfinite (levels)) && ...
     numel (levels) > 1 && abs (sum (sign (diff (levels)))) == ...
     numel (levels) - 1
    n = numel (levels);
    return
  end
  p(end + 1) = checkFault ('badLevels', [field, '.levels'], ...
                           'two and more numbers, rising or falling', ...
                           checkShow (levels), ...
                           ['Put the coarsest and cheapest first, the one ' ...
                            'that counts last.']);
end

function p = checkVariable (given, raw)
  p = checkFault ();
  name = given.variable;
  if iscell (raw.assign) && any (strcmp (name, raw.assign))
    p = checkFault ('levelAssigned', 'Input.coarse', ...
                    'a variable that is not in assign', name, ...
                    'A variable is either calibrated or a level.');
  elseif isstruct (raw.modelVars) && isfield (raw.modelVars, name) && ...
         ~isequal (raw.modelVars.(name), given.levels(end))
    p = checkFault ('levelFixed', ['modelVars.', name], ...
                    sprintf ('the last level, %g', given.levels(end)), ...
                    checkShow (raw.modelVars.(name)), ...
                    ['Take it out: the last level is the one that the ', ...
                     'calibration is for.']);
  end
end

%!function id = firstOf (coarse, change)
%!  raw = struct ('Input', struct ('coarse', {coarse}), 'modelVars', ...
%!                struct (), 'optim', struct (), 'assign', {{'a', 'b'}});
%!  if nargin > 1
%!    raw = change (raw);
%!  end
%!  p = checkLevels (raw, 2);
%!  id = '-';
%!  if ! isempty (p)
%!    id = regexprep (p(1).id, '.*:', '');
%!  end
%!endfunction
%!test
%! good = struct ('variable', 'scaleP', 'levels', [2, 1]);
%! more = setfield (good, 'levels', [3, 2, 1]);
%! fix = @(v) @(raw) setfield (raw, 'modelVars', 'scaleP', v);
%! assert (firstOf ({[], good}), '-');
%! assert (firstOf (good), 'badCoarse');
%! assert (firstOf ({3}), 'badCoarse');
%! assert (firstOf ({good, good, good}), 'coarseCount');
%! assert (firstOf ({good, more}), 'levelCount');
%! for levels = {1, [1, 2, 1], [1, NaN], 'a', [1, 1]}
%!   assert (firstOf ({setfield(good, 'levels', levels{1})}), 'badLevels');
%! end
%! assert (firstOf ({setfield(good, 'variable', 'a')}), 'levelAssigned');
%! assert (firstOf ({good}, fix (2)), 'levelFixed');
%! assert (firstOf ({good}, fix (1)), '-');
%! assert (firstOf ({good, setfield(good, 'levels', [3, 1])}), 'levelsDiffer');
%! assert (firstOf ({good}, @(raw) setfield (raw, 'optim', 'method', ...
%!                                           'published')), 'levelMethod');
