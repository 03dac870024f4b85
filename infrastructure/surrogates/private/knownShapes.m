% KNOWNSHAPES  How results of the models follow parameters, as form.csv has it.
%
% CALL: [SHAPES, OTHERS] = knownShapes (CASE)
%
%   CASE    see newCase
%   SHAPES  1 x T cell of d x 2, slope and curvature along each parameter in the unit
%           box of the case, in the unit of the result up to a factor: the response is
%           near a + b sum_j (slope_j u_j + curvature_j u_j^2); NaN: a parameter that the
%           file does not name; [] where nothing is known of the result
%   OTHERS  1 x m struct, of each model whose runs were seen to end in another way: low,
%           high (1 x d, between which values, -Inf and Inf: said of no parameter),
%           share (of the runs there), times (1 x T, what such a run gives, in parts of
%           what is usual; 1: as usual)
%
% A row of form.csv in the model folder is result, parameter, low, high, slope,
% curvature: with x = (p - low) / (high - low) the result changes by slope x + curvature
% x^2, and beyond low and high as straight as it does there. Rows of parameters that
% the case does not vary say nothing. With other limits, and with logarithms, a
% parabola goes through the two ends and the middle of the limits. Where runs ended in
% another way (a slot that clogs), the columns other, otherLow, otherHigh and otherTimes say
% so: share of the runs between these values, and their mean result over the usual one.
%
% Errors: DEcalioc:knownShapes:badValue

function [shapes, others] = knownShapes (Case)
  T = numel (Case.targets);
  shapes = cell (1, T);
  others = struct ('low', {}, 'high', {}, 'share', {}, 'times', {});
  if ~isfield (Case, 'models')
    return
  end
  info = targetInfo (Case);
  for k = 1:numel (Case.models)
    file = fullfile (Case.models(k).folder, 'form.csv');
    if isempty (Case.models(k).folder) || ~isfile (file)
      continue
    end
    lines = readForm (file);
    seen = struct ('low', -Inf (1, numel (Case.names)), 'high', Inf (1, numel (Case.names)), ...
                   'share', 0, 'times', ones (1, T));
    for t = find ([Case.targets.model] == k)
      name = givenField (Case.targets(t), 'result', '');
      if isempty (name)
        name = info(t).name;
      end
      mine = lines(strcmp ({lines.result}, name));
      shapes{t} = shapeOf (mine, Case.names, Case.limits);
      seen = withOther (seen, mine, t, Case.names);
    end
    if seen.share > 0
      others(end + 1) = seen;
    end
  end
end

% What the lines of target t say of runs that ended in another way.
function seen = withOther (seen, lines, t, names)
  for line = lines(:)'
    o = line.other;
    if ~(o(1) > 0)
      continue
    end
    j = strcmp (names, line.parameter);
    [seen.low(j), seen.high(j)] = deal (o(2), o(3));
    seen.share = max (seen.share, o(1));
    seen.times(t) = o(4);
  end
end

function lines = readForm (file)
  columnsOf = {'result', 'parameter', 'low', 'high', 'slope', 'curvature'};
  [header, cells] = readCsvTable (file);
  [isThere, at] = ismember (columnsOf, lower (header));
  if ~all (isThere)
    error ('DEcalioc:knownShapes:badValue', ...
           ['knownShapes: %s must have the columns %s, got %s. Correct it, or delete ' ...
            'the file.'], file, strjoin (columnsOf, ', '), strjoin (header, ','));
  end
  values = str2double (cells(:, at(3:6)));
  bad = find (~all (isfinite (values), 2) | values(:, 1) >= values(:, 2), 1);
  if ~isempty (bad)
    error ('DEcalioc:knownShapes:badValue', ...
           ['knownShapes: %s must have numbers, low below high, in each row, got %s. ' ...
            'Correct it, or delete the file.'], file, strjoin (cells(bad, :), ','));
  end
  other = otherColumns (header, cells);
  bad = find (other(:, 1) > 0 & ~(other(:, 1) <= 1 & other(:, 2) < other(:, 3) & ...
                                  other(:, 4) >= 0), 1);
  if ~isempty (bad)
    error ('DEcalioc:knownShapes:badValue', ...
           ['knownShapes: %s must have a share up to 1, otherLow below otherHigh and ' ...
            'otherTimes in each row with other, got %s. Correct it, or leave the four ' ...
            'empty.'], file, strjoin (cells(bad, :), ','));
  end
  lines = struct ('result', cells(:, at(1)), 'parameter', cells(:, at(2)), ...
                  'values', num2cell (values, 2), ...
                  'other', num2cell (other, 2));
end

% n x 4, NaN where the file does not have them.
function other = otherColumns (header, cells)
  other = NaN (rows (cells), 4);
  [isThere, at] = ismember ({'other', 'otherlow', 'otherhigh', 'othertimes'}, lower (header));
  if all (isThere)
    other = str2double (cells(:, at));
  end
end

function shape = shapeOf (lines, names, limits)
  shape = NaN (numel (names), 2);
  lines = lines(ismember ({lines.parameter}, names));
  for line = lines(:)'
    j = find (strcmp (names, line.parameter), 1);
    p = fromUnit ([0; 0.5; 1] * ones (size (names)), limits)(:, j);
    z = alongParameter (p, line.values);
    curvature = 2 * (z(1) - 2 * z(2) + z(3));
    shape(j, :) = [z(3) - z(1) - curvature, curvature];
  end
  if ~(any (isfinite (shape(:))) && any (shape(isfinite (shape)) ~= 0))
    shape = [];
  end
end

function z = alongParameter (p, v)
  x = (p - v(1)) / (v(2) - v(1));
  inside = min (max (x, 0), 1);
  z = v(3) * inside + v(4) * inside.^2 + (v(3) + 2 * v(4) * inside) .* (x - inside);
end

%!function Case = caseOf (text)
%!  folder = emptyFolder ();
%!  writeAtomic (fullfile (folder, 'results.csv'), ...
%!               "name,kind,unit,series,at,text\nangle,angle,deg,,,x\nm,mass,kg,,,x\n");
%!  writeAtomic (fullfile (folder, 'form.csv'), text);
%!  Case.models = struct ('name', 'A', 'folder', folder);
%!  Case.targets = struct ('value', {30, 1}, 'model', 1, 'index', {1, 2});
%!  [Case.names, Case.limits] = deal ({'mu', 'rho'}, [0, 1; 1, 2]);
%!endfunction
%!test
%! % limits half as wide; beyond the region straight; what the file does not name
%! text = ["result,parameter,low,high,slope,curvature,runs\n", ...
%!         "angle,mu,0,1,10,-4,50\nangle,e,0,1,3,0,50\n"];
%! Case = caseOf (text);
%! shapes = knownShapes (Case);
%! assert (shapes{1}, [10, -4; NaN, NaN], 1e-12);
%! assert (isempty (shapes{2}));
%! Case.limits(:, 1) = [0; 0.5];
%! assert (knownShapes (Case){1}(1, :), [5, -1], 1e-12);
%! Case.limits(:, 1) = [1; 3];
%! assert (knownShapes (Case){1}(1, :), [4, 0], 1e-12);
%! assert (knownShapes (rmfield (Case, 'models')), cell (1, 2));
%! [~, others] = knownShapes (Case);
%! assert ({numel(others), isfield(others, 'times')}, {0, true});
%!test  % where runs ended in another way
%! text = ["result,parameter,low,high,slope,curvature,runs,other,otherLow,otherHigh,", ...
%!         "otherTimes\nangle,mu,0,1,10,-4,50,0.2,0.6,1,0.3\n", ...
%!         "angle,e,0,1,3,0,50,0.2,0,1,0.3\nm,mu,0,1,1,0,50,,,,\n"];
%! [~, others] = knownShapes (caseOf (text));
%! assert (others, struct ('low', [0.6, -Inf], 'high', [1, Inf], 'share', 0.2, ...
%!                         'times', [0.3, 1]));
%!error id=DEcalioc:knownShapes:badValue
%! knownShapes (caseOf ("result,parameter,low,high\nangle,mu,0,1\n"));
%!error id=DEcalioc:knownShapes:badValue
%! knownShapes (caseOf (["result,parameter,low,high,slope,curvature\n", ...
%!                       "angle,mu,1,0,3,4\n"]));
%!error <otherLow below otherHigh>
%! knownShapes (caseOf (["result,parameter,low,high,slope,curvature,other,otherLow,", ...
%!                       "otherHigh,otherTimes\nangle,mu,0,1,3,4,0.2,,,0.3\n"]));

% SPDX-License-Identifier: GPL-3.0-only
