% FUZZVIEW  Writes a laboratory in other units, another order, other names.
%
% CALL: [GIVEN, DATA, EVALUATE, BACK] = fuzzView (LAB, HOW, SEED)
%
%   LAB    of fuzzLab
%   HOW    cellstr of what changes: 'units' (1e-12 to 1e12, of each target, each
%          bench, each parameter and effect), 'shift', 'sign' (targets), 'runs',
%          'targets', 'effects', 'parameters', 'benches' (their order), 'names',
%          'duplicates' (rows of the table that are there twice)
%   SEED   integer
%   GIVEN, DATA, EVALUATE  for diagnoseMatrices
%   BACK   struct target, effect: for those of LAB their number in the view
%
% See also: fuzzLab, fuzzDiagnoses

function [given, data, evaluate, back] = fuzzView (lab, how, seed)
  rand ('twister', seed);
  randn ('twister', seed);
  [given, data] = deal (lab.given, lab.data);
  is = @(word) any (strcmp (how, word));
  T = numel (given.value);
  p = columns (given.limits);
  K = numel (given.effects);
  v = columns (data.E);
  ten = @(n) 10.^(24 * rand (1, n) - 12);
  orderOf = @(word, n) ifElse (is (word), @() randperm (n), 1:n);
  unit = ifElse (is ('units'), @() unitsOf (ten, given.bench), ones (1, T));
  unit = unit .* ifElse (is ('sign'), @() sign (randn (1, T)), 1);
  shift = ifElse (is ('shift'), @() 10 * randn (1, T), zeros (1, T)) .* unit;
  X = ifElse (is ('units'), @() ten (p), ones (1, p));
  E = ifElse (is ('units'), @() ten (v), ones (1, v));
  at = struct ('target', orderOf ('targets', T), 'param', ...
               orderOf ('parameters', p), 'effect', orderOf ('effects', K));
  written = @(Z) Z .* unit + shift;
  column = columnsOf (given.effects, at.effect);
  given = targetsOf (given, unit, shift);
  given = effectsOf (given, E);
  given.limits = given.limits .* X;
  for name = {'paramMean', 'paramSd'}
    if isfield (given, name{1})
      scaled = given.(name{1}) .* X;
      given.(name{1}) = scaled(at.param);
    end
  end
  given.limits = given.limits(:, at.param);
  given = inOrder (given, at.target, T);
  if K > 0
    given.effects = given.effects(at.effect);
  end
  if is ('benches')
    other = randperm (max (given.bench));
    given.bench = other(given.bench);
  end
  if is ('names')
    given.names = arrayfun (@(k) sprintf ('x%d', k), 1:p, ...
                            'UniformOutput', false);
    given.targetNames = arrayfun (@(k) sprintf ('y %d', k), 1:T, ...
                                  'UniformOutput', false);
  end
  run = orderOf ('runs', rows (data.X));
  if is ('duplicates')
    run = [run, run(1:2:end)];
  end
  [P, Q, Z] = deal (data.X .* X, data.E .* E, written (data.Z));
  data = struct ('X', P(run, at.param), 'E', Q(run, column), ...
                 'Z', Z(run, at.target), 'replicate', data.replicate(run));
  evaluate = [];
  if ~isempty (lab.evaluate)
    known = @(P, Q, r) lab.evaluate (columnsBack (P, at.param) ./ X, ...
                                     columnsBack (Q, column) ./ E, r);
    evaluate = @(P, Q, r) columnsAt (written (known (P, Q, r)), at.target);
  end
  [~, back.target] = sort (at.target);
  [~, back.effect] = sort (at.effect);
end

function value = ifElse (yes, make, other)
  value = other;
  if yes
    value = make ();
  end
end

% A unit of each target, of each bench, or of all.
function unit = unitsOf (ten, bench)
  kind = ceil (3 * rand ());
  unit = ten (numel (bench));
  if kind == 2
    unit = ten (max (bench))(bench);
  elseif kind == 3
    unit(:) = unit(1);
  end
end

function given = targetsOf (given, unit, shift)
  given.value = given.value .* unit + shift;
  given.sd = given.sd .* abs (unit);
  for k = 1:numel (given.effects)
    e = given.effects(k);
    matrix = (e.matrix ./ unit') .* unit;
    given.effects(k).matrix = matrix;
    given.effects(k).offset = e.offset .* unit - shift * matrix;
  end
end

function given = effectsOf (given, E)
  next = 0;
  for k = find (arrayfun (@(e) ~e.laboratory, given.effects))
    next = next + 1;
    given.effects(k).limits = given.effects(k).limits * E(next);
  end
end

% Columns of E in another order of the effects.
function column = columnsOf (effects, order)
  isRun = zeros (1, 0);
  for k = 1:numel (effects)
    isRun(k) = ~effects(k).laboratory;
  end
  number = cumsum (isRun) .* isRun;
  column = number(order);
  column = column(column > 0);
end

function given = inOrder (given, order, T)
  for name = {'value', 'sd', 'bench', 'held', 'series', 'coordinate', ...
              'estimateSeries', 'sdKnown', 'trials'}
    if isfield (given, name{1}) && numel (given.(name{1})) == T
      given.(name{1}) = given.(name{1})(order);
    end
  end
  for k = 1:numel (given.effects)
    given.effects(k).offset = given.effects(k).offset(order);
    given.effects(k).matrix = given.effects(k).matrix(order, order);
  end
end

function Z = columnsAt (Z, order)
  Z = Z(:, order);
end

function P = columnsBack (P, order)
  P(:, order) = P;
end

%!test
%! % a laboratory in another order and other units is the same laboratory
%! lab = fuzzLab (12);
%! [given, data, ~, back] = fuzzView (lab, {'units', 'targets'}, 3);
%! a = (lab.given.value - lab.data.Z(1, :)) ./ max (lab.data.Z);
%! b = ((given.value - data.Z(1, :)) ./ max (data.Z))(back.target);
%! assert (b, a, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
