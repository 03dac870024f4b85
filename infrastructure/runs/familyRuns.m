% FAMILYRUNS  All runs of a store that differ from a case in its inputs alone.
%
% CALL: [FOUND, TALLY] = familyRuns (CASE, H, AGAIN)
%
%   CASE   see newCase;  H  see hashModels
%   AGAIN  1 x M cell of k x 2 (model, number): records that have changed
%   FOUND  struct: inputs n x (d + v), run n x 6 (model, number, seed,
%          replicate, state, first digits of the key, see readLibrary), Z n x T
%          (NaN: of another model, or no result), funs, origin n x 1 cell
%   TALLY   see libraryRuns, with nothing used yet
%
% Same model folder, CPUs and LIGGGHTS, and the same value of every variable but
% design variables, levels and seed; what a run did not set is what data.head
% declares.

function [found, tally] = familyRuns (Case, h, again)
  d = numel (Case.names) + numel (Case.effectVars);
  found = struct ('inputs', zeros (0, d), 'run', zeros (0, 6), ...
                  'Z', zeros (0, numel (Case.targets)), ...
                  'funs', {cell(0, 1)}, 'origin', {cell(0, 1)});
  tally = struct ('used', 0, 'origin', {{}}, 'count', []);
  tally.passed = struct ('model', {}, 'why', {}, 'count', {});
  tally.other = struct ('model', {}, 'number', {}, 'count', {});
  for k = 1:numel (Case.models)
    isOfModel = [Case.targets.model] == k;
    index = [Case.targets(isOfModel).index];
    kinds = readLibrary (Case.store, Case.models(k).name, h(k), ...
                         again{k}(:, 2:end));
    other = zeros (0, 1);
    for kind = kinds
      kind.runs = kind.runs(ismember (kind.runs(:, 2), [1, 2, 3]), :);
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
      first = 6 + numel (strsplit (kind.names, ' '));
      isOk = runs(:, 2) == 1 & columns (runs) >= first + max (index);
      Z(isOk, isOfModel) = runs(isOk, first + index);
      found.inputs = [found.inputs; inputs(isOf, :)];
      found.run = [found.run; k * ones(n, 1), runs(:, [1, 5, 6, 2, 3])];
      found.Z = [found.Z; Z];
      found.funs = [found.funs; repmat({kind.funs}, n, 1)];
      found.origin = [found.origin; repmat({kind.origin}, n, 1)];
    end
    if ~isempty (other)
      tally.other(end + 1) = struct ('model', k, 'number', max (other), ...
                                     'count', numel (other));
    end
  end
end

% Inputs of the runs of a kind as this case has them, and which runs differ in
% nothing else.
function [inputs, isOf, why] = inputsOf (kind, Case, h)
  names = strsplit (kind.names, ' ');
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
%!  none = repmat ({zeros(0, 1)}, 1, 2);
%!  [found, tally] = familyRuns (Case, hashModels (Case), none);
%!endfunction

%!test
%! % one parameter is fixed here and was free there, and the other way round
%! first = newCase (standInCase (tempname ()));
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
%! found = familyRuns (Case, hashModels (Case), repmat ({zeros(0, 1)}, 1, 2));
%! assert (sum (all (found.inputs == [2, 2, 3], 2)), 2);
%! assert (rows (found.inputs), 10);
%! [found, tally] = of (first.store, {'a', 'e'}, struct ('b', 6));
%! assert (found.inputs, [5, 0; 7, 0; 5, 0; 7, 0]);
