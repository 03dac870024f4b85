% WITHEARLIER  Adds to a problem what is known before the first run.
%
% CALL: PROBLEM = withEarlier (PROBLEM, CASE)
%
%   PROBLEM  see newProblem; gets prior (of Input.similar), shape and others (of form.csv,
%            see knownShapes)
%   CASE     see newCase
%
% Errors: those of knownShapes, loadSurrogate

function problem = withEarlier (problem, Case)
  problem.prior = similarPriors (Case);
  [problem.shape, problem.others] = knownShapes (Case);
end

% Of the surrogates of a similar bench (Input.similar, a folder with the results of another
% case): PRIOR 1 x T cell, see krigingModel, from the surrogate of the target of the same
% name. Ranges are known of the parameters that have the same name there, in their own
% units: with other limits they are other shares of the box; of one that counts in
% logarithms here or there alone nothing is known. A surrogate with levels, or of known
% noise, says nothing.
function prior = similarPriors (Case)
  prior = cell (1, 0);
  folder = givenField (Case.options, 'similar', '');
  if isempty (folder)
    return
  end
  place = fullfile (folder, 'results');
  c = readJsonFile (fullfile (place, 'calibration.json'));
  files = dir (fullfile (place, 'surrogates', 'KM_fun_*.txt'));
  old = cellfun (@(f) loadSurrogate (fullfile (place, 'surrogates', f)), ...
                 {files.name}, 'UniformOutput', false);
  names = cellfun (@(s) s.name, old, 'UniformOutput', false);
  prior = cell (1, numel (Case.targets));
  [isThere, column] = ismember (Case.names, fieldnames (c.params));
  for t = 1:numel (prior)
    k = find (strcmp (names, Case.targets(t).name), 1);
    d = numel (fieldnames (c.params));
    if isempty (k) || numel (old{k}.model.param) ~= d + 1 || ...
       ~isscalar (old{k}.model.lognoisevariance)
      continue
    end
    % about the trend that a new surrogate starts with
    s = fitSurrogate (old{k}.X, old{k}.z, old{k}.limits, ...
                      struct ('trend', 'affine', 'covariance', 'matern52'));
    prior{t} = NaN (numel (Case.names) + 2, 1);
    prior{t}([1, end]) = [s.model.param(1); s.model.lognoisevariance];
    width = widthsOf (Case.limits)(:, isThere) ./ ...
            widthsOf (s.limits)(:, column(isThere));
    prior{t}(1 + find (isThere)) = s.model.param(1 + column(isThere))(:) + ...
                                   log (max (width, [], 1)(:));
  end
end

% In a parameter's own unit, and in logarithms; NaN where it does not count so.
function w = widthsOf (limits)
  isLog = any (limits(3:min (end, 3), :), 1);
  w = [limits(2, :) - limits(1, :); log(limits(2, :) ./ limits(1, :))];
  w(1, isLog) = NaN;
  w(2, ~isLog) = NaN;
  w(:, any (limits(4:end, :), 1)) = NaN;
end

%!test
%! Case = struct ('options', struct (), 'targets', struct ('value', {1, 2}));
%! known = withEarlier (struct ('tol', 1), Case);
%! assert (isempty (known.others));
%! known = rmfield (known, 'others');
%! assert (known, struct ('tol', 1, 'prior', {cell(1, 0)}, 'shape', {cell(1, 2)}));
%!test
%! % ranges go with the parameter, in its unit; targets by their name
%! rand ('twister', 4);
%! folder = tempname ();
%! [~, ~] = mkdir (fullfile (folder, 'results', 'surrogates'));
%! X = rand (20, 2);
%! s = fitSurrogate (X, sin (9 * X(:, 1)) + X(:, 2), [0, 0; 1, 1], ...
%!                   struct ('name', 'slope'));
%! saveSurrogate (fullfile (folder, 'results', 'surrogates', ...
%!                          'KM_fun_1.txt'), s);
%! writeAtomic (fullfile (folder, 'results', 'calibration.json'), ...
%!              jsonencode (struct ('params', struct ('a', 1, 'b', 2))));
%! Case = struct ('names', {{'b', 'a', 'c'}}, 'limits', [0, 0, 0; 1, 2, 1]);
%! Case.targets = struct ('name', {'slope', 'mass'});
%! Case.options.similar = folder;
%! p = withEarlier (struct (), Case).prior;
%! assert (isempty (p{2}));
%! s = fitSurrogate (X, s.z, s.limits, struct ('trend', 'affine', ...
%!                                             'covariance', 'matern52'));
%! theta = s.model.param;
%! assert (p{1}(1:3), [theta(1); theta(3); theta(2) + log(2)], 1e-6);
%! assert (isnan (p{1}(4)));
%! assert (p{1}(5), s.model.lognoisevariance, 1e-6);
%! % with it few runs know the short range of a
%! few = rand (8, 3);
%! z = few(:, 1) + sin (9 * few(:, 2));
%! own = fitSurrogate (few, z, [0, 0, 0; 1, 1, 1], struct ('prior', p{1}));
%! plain = fitSurrogate (few, z, [0, 0, 0; 1, 1, 1]);
%! if (! isempty (own.prior))
%!   assert (abs (own.model.param(3) - p{1}(3)) < ...
%!           abs (plain.model.param(3) - p{1}(3)) + 0.5);
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
