% SAVESURROGATES  Keeps surrogates in a folder: to be read again, to be called.
%
% CALL: NAMES = saveSurrogates (SURROGATES, FOLDER [, ISCALLED])
%
% FOLDER      folder that holds them, made where it is missing (text)
% NAMES       1 x T cellstr, KM_fun_<i>. Of each there are two files:
%             <name>.txt, runs and parameters for loadSurrogate, and <name>.m,
%             an Octave function Z = KM_fun_<i> (PARAMS), n x d -> n x 1, that
%             gives the mean response and needs neither DEcalioc nor a package
% ISCALLED    logical (true); false: without the functions

function names = saveSurrogates (surrogates, folder, isCalled)
  [~, ~] = mkdir (folder);
  names = arrayfun (@(t) sprintf ('KM_fun_%d', t), 1:numel (surrogates), ...
                    'UniformOutput', false);
  for t = 1:numel (surrogates)
    saveSurrogate (fullfile (folder, [names{t}, '.txt']), surrogates(t));
    if nargin < 3 || isCalled
      writeAtomic (fullfile (folder, [names{t}, '.m']), ...
                   functionOf (names{t}, surrogates(t)));
    end
  end
end

% The posterior mean of krigingPosterior, written out.
function text = functionOf (name, s)
  d = columns (s.limits);
  n = rows (s.solver.unit);
  param = s.model.param(:)';
  weights = exp (param(1)) * s.solver.alpha;
  [correlation, first] = correlationText (s.covariance, exp (param(2)));
  rates = exp (param(first:end)) .* ones (1, columns (s.solver.unit));
  lines = {['function z = ', name, ' (params)'], ...
           ['  % ', upper(name), '  Kriging model of ', ...
            regexprep(s.name, '\s+', ' '), ', made by DEcalioc.'], ...
           '  %', ...
           sprintf('  %% params  n x %d, sets; z  n x 1, mean response', d), ...
           sprintf('  %% From %d runs; %s trend, %s.', n, trendName (s.trend), ...
                   s.covariance), ...
           sprintf('  if columns (params) ~= %d', d), ...
           '    params = params(:)'';', ...
           '  end', ...
           ['  limits = ', mat2str(s.limits, 17), ';'], ...
           unitLines(s.limits), ...
           sprintf('  u(:, %d:%d) = 0;', d + 1, numel (rates)), ...
           ['  trend = ', mat2str(s.solver.beta, 17), ';'], ...
           ['  h = ', trendTerms(s.trend, numel (rates)), ';'], ...
           ['  runs = ', mat2str(s.solver.unit, 17), ';'], ...
           ['  weights = ', mat2str(weights, 17), ';'], ...
           ['  rates = ', mat2str(rates, 17), ';'], ...
           '  q2 = zeros (rows (u), rows (runs));', ...
           '  for j = 1:columns (u)', ...
           '    q2 = q2 + (rates(j) * (u(:, j) - runs(:, j)'')).^2;', ...
           '  end', ...
           ['  ', correlation, ';'], ...
           sprintf('  z = %.17g + %.17g * (h * trend + k * weights);', ...
                   s.shift, s.scale), ...
           'end', ''};
  text = strjoin (lines, "\n");
end

% As stk_rbf_matern and the like, of the squared scaled distances q2; FIRST is the
% first range among the parameters.
function [text, first] = correlationText (covariance, nu)
  first = 2;
  switch strrep (covariance, '_iso', '')
    case 'matern52'
      text = 't = sqrt (10 * q2); k = (1 + t + t.^2 / 3) .* exp (-t)';
    case 'matern32'
      text = 't = sqrt (6 * q2); k = (1 + t) .* exp (-t)';
    case 'gauss'
      text = 'k = exp (-q2)';
    case 'exp'
      text = 'k = exp (-sqrt (2 * q2))';
    case 'sph'
      text = 't = min (sqrt (q2), 1); k = (1 - t).^2 .* (1 + 0.5 * t)';
    case 'matern'
      first = 3;
      text = sprintf (['nu = %.17g; t = 2 * sqrt (nu * q2);\n', ...
                       '  c = 0.5 * exp (gammaln (nu) - nu * log (0.5 * t)); ', ...
                       'k = exp (-q2);\n', ...
                       '  k(isfinite (c)) = (besselk (nu, t) ./ c)', ...
                       '(isfinite (c))'], nu);
  end
end

% As toUnit.
function text = unitLines (limits)
  text = '  u = (params - limits(1, :)) ./ (limits(2, :) - limits(1, :));';
  isLog = any (limits(3:min (end, 3), :), 1);
  if any (isLog)
    text = sprintf (['%s\n  k = [%s];\n  u(:, k) = max (log (max ', ...
                     '(params(:, k), 0) ./ limits(1, k)) ./ ...\n', ...
                     '                 log (limits(2, k) ./ ', ...
                     'limits(1, k)), -1);'], text, num2str (find (isLog)));
  end
  bends = any (limits(4:end, :), 1);
  if any (bends)
    text = sprintf (['%s\n  k = [%s];\n  u(:, k) = expm1 (limits(4, k) .* ', ...
                     'u(:, k)) ./ expm1 (limits(4, k));'], text, ...
                    num2str (find (bends)));
  end
end

function name = trendName (trend)
  name = 'known';
  if ischar (trend)
    name = trend;
  end
end

% In the order of stk_lm_constant, _affine, _quadratic, and of trendOf.
function text = trendTerms (trend, d)
  if ~ischar (trend)
    isKnown = isfinite (trend(:, 1)');
    text = sprintf (['[ones(rows (u), 1), [u(:, [%s]), u(:, [%s]).^2] * %s, ', ...
                     'u(:, [%s])]'], num2str (find (isKnown)), ...
                    num2str (find (isKnown)), mat2str (trend(isKnown, :)(:), 17), ...
                    num2str ([find(~isKnown), numel(isKnown) + 1:d]));
    return
  end
  text = 'ones(rows (u), 1)';
  if ~strcmp (trend, 'constant')
    text = [text, ', u'];
  end
  if strcmp (trend, 'quadratic')
    text = [text, sprintf(', u(:, %d) .* u(:, %d:end)', [1:d; 1:d])];
  end
  text = ['[', text, ']'];
end

%!test
%! % read again, and called: each trend, each covariance, a level
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (16, 2) .* [2, 30] + [1, -10];
%! z = 3 + X(:, 1).^2 + sin (X(:, 2) / 5);
%! limits = [1, -10; 3, 20];
%! trends = {'constant', 'affine', 'quadratic', 'affine', 'affine', ...
%!           'constant', 'constant', 'constant'};
%! kernels = {'gauss', 'matern32', 'matern52', 'matern52', 'matern', 'exp', ...
%!            'sph', 'matern_iso'};
%! levels = {[], [], [], mod(1:16, 2)', [], [], [], []};
%! trends{9} = [2, 0.5; NaN, NaN];        % a shape that form.csv knows
%! [kernels{9}, levels{9}] = deal ('matern52', []);
%! for t = 1:9
%!   s(t) = fitSurrogate (X, z, limits, ...
%!                        struct ('trend', trends{t}, 'level', levels{t}, ...
%!                                'covariance', kernels{t}, 'name', 'a name', ...
%!                                'published', t > 4 && t < 9));
%! end
%! folder = fullfile (tempname (), 'KrigingFuns');
%! names = saveSurrogates (s, folder);
%! addpath (folder);
%! P = limits(1, :) + rand (6, 2) .* diff (limits);
%! called = cell2mat (cellfun (@(f) feval (f, P), names, ...
%!                             'UniformOutput', false));
%! one = KM_fun_2 (P(3, :)');
%! again = loadSurrogate (fullfile (folder, 'KM_fun_2.txt'));
%! shaped = loadSurrogate (fullfile (folder, 'KM_fun_9.txt'));
%! rmpath (folder);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');
%! assert (names([1, 8]), {'KM_fun_1', 'KM_fun_8'});
%! m = predictSurrogate (s, P);
%! assert (called, m, 1e-6);         % without a prior weights grow large
%! assert (one, m(3, 2), 1e-9);
%! assert (again.z, s(2).z);
%! assert (predictSurrogate (shaped, P), m(:, 9), 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
