% JOINMODELS  Makes rows of the table of evaluations of single runs.
%
% CALL: [DATA, ROW] = joinModels (INPUTS, MODEL, SEED, Z, CASE)
%
%   INPUTS  n x (d + v), parameters and effect values of the runs
%   MODEL, SEED  n x 1, number of the model, seed (NaN: not known)
%   Z       n x T, NaN where a run gave nothing
%   CASE    names, models and targets are read
%   DATA    see newData, stage 'import': runs of different models with the same
%           inputs are one row, NA for a model that was not run there; a model
%           that has the same inputs twice was repeated with another seed
%           (replicate 2, 3 ...); an exact repeat, same seed and results, counts
%           once
%   ROW     n x 1, number of the row of each run; 0: an exact repeat

function [data, row] = joinModels (inputs, model, seed, Z, Case)
  whole = [inputs, model, seed, Z];
  whole(isnan (whole)) = pi * 1e300;
  [~, once] = unique (whole, 'rows', 'first');
  keep = unique ([once(:); find(isnan (seed))]);
  [inputs, model, Z] = deal (inputs(keep, :), model(keep), Z(keep, :));
  [~, ~, group] = unique (inputs, 'rows', 'first');
  n = rows (inputs);
  % the rank of a row among those of its set and its model
  [sorted, order] = sortrows ([group(:), model(:), (1:n)']);
  isNew = true (n, 1);
  isNew(2:n) = any (diff (sorted(:, 1:2), 1, 1) ~= 0, 2);
  starts = find (isNew);
  replicate(order, 1) = (1:n)' - starts(cumsum (isNew)) + 1;
  [~, first, row] = unique ([group(:), replicate], 'rows', 'first');
  [~, order] = sort (first);
  place(order) = 1:numel (order);
  row = place(row)(:);
  d = numel (Case.names);
  data.X = inputs(first(order), 1:d);
  data.E = inputs(first(order), d + 1:end);
  data.Z = NA (numel (first), columns (Z));
  for k = 1:numel (Case.models)
    isOfModel = [Case.targets.model] == k;
    data.Z(row(model == k), isOfModel) = Z(model == k, isOfModel);
  end
  data.replicate = replicate(first(order));
  data.stage = repmat ({'import'}, numel (first), 1);
  at = row;
  row = zeros (numel (seed), 1);
  row(keep) = at;
end

%!test
%! % two models, one of which was repeated; an exact repeat
%! Case = struct ('names', {{'a'}}, 'models', struct ('name', {'A', 'B'}), ...
%!                'targets', struct ('model', {1, 2}));
%! [data, row] = joinModels ([1; 1; 1; 2; 2], [1; 2; 1; 2; 2], ...
%!                           [7; 7; 9; 5; 5], ...
%!                           [3, NaN; NaN, 4; 5, NaN; NaN, 6; NaN, 6], Case);
%! assert (data.X, [1; 1; 2]);
%! assert (isequaln (data.Z, [3, 4; 5, NA; NA, 6]));
%! assert (row', [1, 1, 2, 3, 0]);

% SPDX-License-Identifier: GPL-3.0-only
