% CHECKTARGETS  Checks the target values of optim and how many there are.
%
% CALL: [P, SIZES] = checkTargets (OPTIM, MODELS)
%
%   OPTIM   scalar struct, the optim of loadInput
%   MODELS  1 x M struct array, see checkFindModels; its field count is the
%           number of results that getResults returns (NaN: not known)
%   P       1 x n faults, see checkFault
%   SIZES   1 x M, targets of each model; [] where they make no sense
%
% Reasons: missingField badTargets targetCount ambiguousTargets
% nonFiniteTarget zeroTarget

function [p, sizes] = checkTargets (optim, models)
  sizes = [];
  field = 'optim.targetVal';
  expected = 'a cell of numbers, {k}(i) for result i of model k';
  cure = 'Write optim.targetVal{1}(1) = 400; and so on.';
  if ~isfield (optim, 'targetVal')
    p = checkFault ('missingField', field, expected, 'nothing', cure);
    return
  end
  value = optim.targetVal;
  [values, fields, given] = checkElements (value, field);
  if isempty (given) || any (given == 0) || ...
     (iscell (value) && any (cellfun (@iscell, value)))
    p = checkFault ('badTargets', field, expected, checkShow (value), cure);
    return
  end
  p = checkValues ([values{:}], fields);
  if isempty (models)
    return
  end
  if iscell (value)
    [q, sizes] = countCells (given, models);
  else
    [q, sizes] = countColumn (given, models);
  end
  p = [p, q];
end

function p = checkValues (values, fields)
  p = checkFault ();
  for i = 1:numel (values)
    if ~isfinite (values(i))
      p(end + 1) = checkFault ('nonFiniteTarget', fields{i}, ...
                               'a finite number', checkShow (values(i)), ...
                               'Set the measured value.');
    elseif values(i) == 0
      p(end + 1) = checkFault ('zeroTarget', fields{i}, ...
                               'a number that is not 0', '0', ...
                               ['Give it in measured.csv with an ' ...
                                'absolute tolerance, or let getResults ' ...
                                'return a shifted value.']);
    end
  end
end

function [p, sizes] = countCells (given, models)
  p = checkFault ();
  sizes = given;
  if numel (given) ~= numel (models)
    sizes = [];
    p = checkFault ('targetCount', 'optim.targetVal', ...
                    sprintf ('%d cell(s), one a model', numel (models)), ...
                    sprintf ('%d', numel (given)), ...
                    'Write optim.targetVal{k}(i) for every model k.');
    return
  end
  for k = find (~isnan ([models.count]) & [models.count] ~= given)
    p(end + 1) = checkFault ('targetCount', ...
                             sprintf ('optim.targetVal{%d}', k), ...
                             expectedCount (models(k)), ...
                             sprintf ('%d', given(k)), countCure ());
  end
end

function [p, sizes] = countColumn (given, models)
  p = checkFault ();
  counts = [models.count];
  sizes = counts;
  if isscalar (models)
    sizes = given;
  elseif any (isnan (counts))
    sizes = [];
    p = checkFault ('ambiguousTargets', 'optim.targetVal', ...
                    'a cell with the targets of each model', ...
                    sprintf (['one column of %d for %d models, and ' ...
                              'getResults of %s does not tell how many ' ...
                              'are its own'], given, numel (models), ...
                             models(find (isnan (counts), 1)).name), ...
                    ['Take the line optim.targetVal = horzcat (...) out ' ...
                     'of loadInput.m.']);
    return
  end
  if ~any (isnan (counts)) && given ~= sum (counts)
    sizes = [];
    texts = arrayfun (@expectedCount, models, 'UniformOutput', false);
    p = checkFault ('targetCount', 'optim.targetVal', ...
                    strjoin (texts, ' and '), sprintf ('%d', given), ...
                    countCure ());
  end
end

function text = expectedCount (model)
  text = sprintf ('%d value(s), as many as getResults of %s returns', ...
                  model.count, model.name);
end

function text = countCure ()
  text = 'Give one target for each result, in the order of getResults.';
end

%!test
%! models = struct ('name', {'A', 'B'}, 'count', {2, 1});
%! [p, n] = checkTargets (struct ('targetVal', {{[1, 2], 3}}), models);
%! assert ({isempty(p), n}, {true, [2, 1]});
%! [p, n] = checkTargets (struct ('targetVal', [1; 2; 3]), models);
%! assert ({isempty(p), n}, {true, [2, 1]});
%! p = checkTargets (struct ('targetVal', {{[0, NaN], [3, 4]}}), models);
%! assert ({p.id}, strcat ('DEcalioc:checkCase:', ...
%!         {'zeroTarget', 'nonFiniteTarget', 'targetCount'}));
%! models(2).count = NaN;
%! p = checkTargets (struct ('targetVal', [1; 2; 3]), models);
%! assert (p.id, 'DEcalioc:checkCase:ambiguousTargets');
