% FAMILYRUNS  All runs of a store that differ from a case in its inputs alone.
%
% CALL: [FOUND, TALLY] = familyRuns (CASE, H, AGAIN)
%
%   CASE   see newCase;  H  see hashModels
%   AGAIN  k x 2 (model, number): records that are to be read, whatever the
%          index says
%   FOUND  struct: inputs n x (d + v), run n x 5 (model, number, seed,
%          replicate, state, see readLibrary), Z n x T (NaN: of another model,
%          or no result), isRead n x 1 logical (false: the run ended well, but
%          has not answered what this case asks), origin n x 1 cell
%          (label of readLibrary)
%   TALLY   see libraryRuns, with nothing used yet
%
% Same model folder, CPUs and LIGGGHTS, and the same value of every variable but
% design variables, levels and seed; what a run did not set is what data.head
% declares.

function [found, tally] = familyRuns (Case, h, again)
  d = numel (Case.names) + numel (Case.effectVars);
  found = struct ('inputs', zeros (0, d), 'run', zeros (0, 5), ...
                  'Z', zeros (0, numel (Case.targets)), ...
                  'isRead', false (0, 1), 'origin', {cell(0, 1)});
  tally = struct ('used', 0, 'origin', {{}}, 'count', []);
  tally.passed = struct ('model', {}, 'why', {}, 'count', {});
  tally.other = struct ('model', {}, 'number', {}, 'count', {});
  for k = 1:numel (Case.models)
    isOfModel = [Case.targets.model] == k;
    index = [Case.targets(isOfModel).index];
    [kinds, torn] = readLibrary (runPlace (Case, Case.models(k).name), ...
                                 again(again(:, 1) == k, 2));
    tally.passed = booked (tally.passed, Case.models(k).name, ...
                           'their records cannot be read', numel (torn));
    other = zeros (0, 1);
    seen = zeros (0, 1);
    for kind = inOrder (kinds, h(k))
      isNew = ~ismember (kind.runs(:, 1), seen);
      seen = [seen; kind.runs(isNew, 1)];
      kind.runs = kind.runs(isNew & ismember (kind.runs(:, 2), 1:3), :);
      if ~strcmp (kind.input, h(k).input)
        other = [other; kind.runs(:, 1)];
        continue
      end
      [inputs, isOf, why] = inputsOf (kind, Case, h(k));
      tally.passed = booked (tally.passed, Case.models(k).name, why, ...
                             sum (~isOf));
      runs = kind.runs(isOf, :);
      n = rows (runs);
      Z = NaN (n, numel (Case.targets));
      isOk = runs(:, 2) == 1 & answers (kind, h(k)) == 2;
      Z(isOk, isOfModel) = runs(isOk, end - h(k).count + index);
      found.inputs = [found.inputs; inputs(isOf, :)];
      found.run = [found.run; k * ones(n, 1), runs(:, [1, 5, 6, 2])];
      found.Z = [found.Z; Z];
      found.isRead = [found.isRead; runs(:, 2) == 3 | answers(kind, h(k)) > 0];
      found.origin = [found.origin; repmat({kind.label}, n, 1)];
    end
    if ~isempty (other)
      tally.other(end + 1) = struct ('model', k, 'number', max (other), ...
                                     'count', numel (other));
    end
  end
end

% The question of the case first.
function kinds = inOrder (kinds, h)
  [~, order] = sort (arrayfun (@(kind) ~answers (kind, h), kinds));
  kinds = kinds(order);
end

% 0 another question, or one for more or fewer results; 1 no results; 2 results
function code = answers (kind, h)
  n = columns (kind.runs) - 6 - sum (kind.names == ' ') - ~isempty (kind.names);
  code = strcmp (kind.funs, h.funs) * ((n == 0) + 2 * (n == h.count));
end

% Inputs of the runs of a kind as this case has them, and which runs differ in
% nothing else.
function [inputs, isOf, why] = inputsOf (kind, Case, h)
  names = strsplit (kind.names, ' ');
  names = names(~cellfun (@isempty, names));
  values = toDigits (kind.runs(:, 7:6 + numel (names)));
  n = rows (values);
  free = [Case.names, Case.effectVars];
  inputs = zeros (n, numel (free));
  isOf = true (n, 1);
  why = '';
  for name = unique ([names, free, fieldnames(Case.modelVars)'])
    declared = toDigits (givenField (h.defaults, name{1}, NaN));
    was = repmat (declared, n, 1);
    column = find (strcmp (names, name{1}));
    if ~isempty (column)
      was = values(:, column);
    end
    now = toDigits (givenField (Case.modelVars, name{1}, declared));
    isFree = strcmp (free, name{1});
    if any (isFree)
      inputs(:, isFree) = was;
      fits = isfinite (was);
      for coarse = Case.coarse(strcmp ({Case.coarse.variable}, name{1}))
        fits = ismember (was, coarse.levels);
        now = coarse.levels(end);
      end
    elseif any (strcmp (name{1}, {'runSeed', 'RLTS', 'SIMTS'}))
      continue                          % they follow of the others
    else
      fits = was == now | (isnan (was) & isnan (now));
    end
    if ~all (fits) && isempty (why)
      why = sprintf ('their %s is not %g', name{1}, now);
    end
    isOf = isOf & fits;
  end
  today = assignParams (Case.modelVars, Case.limits(2, :), Case.names);
  if isfield (today, 'SIMTS') ~= any (strcmp (names, 'SIMTS'))
    isOf(:) = false;
    why = 'another time step';
  end
end

function passed = booked (passed, model, why, n)
  k = find (strcmp ({passed.model}, model) & strcmp ({passed.why}, why));
  if ~isempty (k)
    passed(k).count = passed(k).count + n;
  elseif n > 0
    passed(end + 1) = struct ('model', model, 'why', why, 'count', n);
  end
end

%!function [found, tally, Case] = of (store, names, modelVars)
%!  raw = standInCase (tempname ());
%!  raw.Input.store = store;
%!  raw.assign = names;
%!  raw.paramLims = raw.paramLims(:, 1:numel (names));
%!  raw.modelVars = modelVars;
%!  Case = newCase (raw);
%!  [found, tally] = familyRuns (Case, hashModels (Case), zeros (0, 2));
%!endfunction

%!test
%! % one parameter is fixed here and was free there, and the other way round
%! first = readyCase ();
%! evaluateDEM ([1, 2; 3, 4; 5, 6], first);
%! [found, tally, Case] = of (first.store, {'a'}, struct ('b', 6));
%! assert ({found.inputs, tally.passed.count}, {[5; 5], 2, 2});
%! assert (found.Z, [11, 30, NaN; NaN, NaN, -1], 1e-12);
%! assert (strfind (tally.passed(1).why, 'their b is not 6'), 1);
%! evaluateDEM (7, Case);
%! found = of (first.store, {'a', 'b'}, struct ());
%! assert (sum (all (found.inputs == [7, 6], 2)), 2);
%! % what data.head declares counts where a run did not set it
%! assert (rows (of (first.store, {'a', 'b'}, struct ('e', 1)).inputs), 0);
%! assert (rows (of (first.store, {'a', 'b'}, struct ('e', 0)).inputs), 8);
%! % a variable of levels: runs at its levels, and no others
%! [~, ~, Case] = of (first.store, {'a', 'b'}, struct ());
%! evaluateDEM ([2, 2], setfield (Case, 'modelVars', struct ('e', 3)));
%! evaluateDEM ([2, 3], setfield (Case, 'modelVars', struct ('e', 2)));
%! Case.coarse = struct ('variable', 'e', 'levels', [3, 0], 'models', 1:2);
%! Case.effectVars = {'e'};
%! found = familyRuns (Case, hashModels (Case), zeros (0, 2));
%! assert (sum (all (found.inputs == [2, 2, 3], 2)), 2);
%! assert (rows (found.inputs), 10);
%! [found, tally] = of (first.store, {'a', 'e'}, struct ('b', 6));
%! assert (found.inputs, [5, 0; 7, 0; 5, 0; 7, 0]);

% SPDX-License-Identifier: GPL-3.0-only
