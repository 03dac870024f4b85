% SAVESURROGATES  Keeps surrogates in a folder: to be read again, to be called.
%
% CALL: NAMES = saveSurrogates (SURROGATES, FOLDER)
%
% SURROGATES  1 x T struct array, see fitSurrogate
% FOLDER      folder that holds them, made where it is missing (text)
% NAMES       1 x T cellstr, KM_fun_<i>. Of each there are two files:
%             <name>.txt, runs and parameters for loadSurrogate, and <name>.m,
%             an Octave function Z = KM_fun_<i> (PARAMS), n x d -> n x 1, that
%             gives the mean response and needs neither DEcalioc nor a package
%
% See also: saveSurrogate, createKrigingModels

function names = saveSurrogates (surrogates, folder)
  [~, ~] = mkdir (folder);
  names = arrayfun (@(t) sprintf ('KM_fun_%d', t), 1:numel (surrogates), ...
                    'UniformOutput', false);
  for t = 1:numel (surrogates)
    saveSurrogate (fullfile (folder, [names{t}, '.txt']), surrogates(t));
    writeAtomic (fullfile (folder, [names{t}, '.m']), ...
                 functionOf (names{t}, surrogates(t)));
  end
end

% The posterior mean of krigingTerms, written out.
function text = functionOf (name, s)
  d = columns (s.limits);
  n = rows (s.solver.unit);
  rates = exp (s.model.param(2:end))(:)';
  weights = exp (s.model.param(1)) * s.solver.alpha;
  q = struct ('matern52', ...
              't = sqrt (10 * q2); k = (1 + t + t.^2 / 3) .* exp (-t)', ...
              'matern32', 't = sqrt (6 * q2); k = (1 + t) .* exp (-t)', ...
              'gauss', 'k = exp (-q2)');
  lines = {['function z = ', name, ' (params)'], ...
           ['  % ', upper(name), '  Kriging model of ', ...
            regexprep(s.name, '\s+', ' '), ', made by DEcalioc.'], ...
           '  %', ...
           sprintf('  %% params  n x %d, sets; z  n x 1, mean response', d), ...
           sprintf('  %% From %d runs; %s trend, %s.', n, s.trend, ...
                   s.covariance), ...
           sprintf('  if columns (params) ~= %d', d), ...
           '    params = params(:)'';', ...
           '  end', ...
           ['  limits = ', mat2str(s.limits, 17), ';'], ...
           '  u = (params - limits(1, :)) ./ diff (limits);', ...
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
           ['  ', q.(s.covariance), ';'], ...
           sprintf('  z = %.17g + %.17g * (h * trend + k * weights);', ...
                   s.shift, s.scale), ...
           'end', ''};
  text = strjoin (lines, "\n");
end

% In the order of stk_lm_constant, _affine, _quadratic.
function text = trendTerms (trend, d)
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
%! trends = {'constant', 'affine', 'quadratic', 'affine'};
%! kernels = {'gauss', 'matern32', 'matern52', 'matern52'};
%! for t = 1:4
%!   options = struct ('trend', trends{t}, 'covariance', kernels{t}, ...
%!                     'name', 'a name');
%!   if t == 4
%!     options.level = mod (1:16, 2)';
%!   end
%!   s(t) = fitSurrogate (X, z, limits, options);
%! end
%! folder = fullfile (tempname (), 'KrigingFuns');
%! names = saveSurrogates (s, folder);
%! addpath (folder);
%! P = limits(1, :) + rand (6, 2) .* diff (limits);
%! called = cell2mat (cellfun (@(f) feval (f, P), names, ...
%!                             'UniformOutput', false));
%! one = KM_fun_2 (P(3, :)');
%! again = loadSurrogate (fullfile (folder, 'KM_fun_2.txt'));
%! rmpath (folder);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');
%! assert (names, {'KM_fun_1', 'KM_fun_2', 'KM_fun_3', 'KM_fun_4'});
%! m = predictSurrogate (s, P);
%! assert (called, m, 1e-9);
%! assert (one, m(3, 2), 1e-9);
%! assert (again.z, s(2).z);
