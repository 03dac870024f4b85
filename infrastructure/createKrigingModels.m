% CREATEKRIGINGMODELS  One Kriging model per response, kept as data.
%
% CALL: [NAMES, FOLDER, SURROGATES] = createKrigingModels (EXPLANFILES,
%         RESPFILES, PARAMLIMS, TREND, COVARIANCE)
%       [NAMES, FOLDER, SURROGATES] = createKrigingModels (DATA, PROBLEM)
%       [NAMES, FOLDER, SURROGATES] = createKrigingModels (SURROGATES), fitted before
%
% EXPLANFILES  text or cellstr: CSV of the plan (n x d), one for all responses
%              or one per response
% RESPFILES    cellstr: CSV of one response each (n rows, NaN: failed); a cell
%              of cells (one per model) is unfolded
% PARAMLIMS    2 x d  limits of the design variables
% TREND        'stk_lm_constant', 'stk_lm_affine' or 'stk_lm_quadratic', or as
%              in early versions 1 (linear) or 2 (quadratic) ('stk_lm_affine')
% COVARIANCE   name of stk: stk_materncov_aniso (regularity estimated),
%              stk_materncov52_aniso, stk_materncov32_aniso, stk_gausscov_aniso,
%              stk_expcov_aniso, stk_sphcov_aniso, or _iso instead of _aniso
%              ('stk_materncov_aniso')
% DATA         struct of newData: the finished runs, replicates among them
% PROBLEM      struct of newProblem; trend and covariance are chosen
% NAMES        T x 2 cellstr: 'KM_fun_1' ..., and the file of its responses
%              (of DATA the name of the target)
% FOLDER       text, the folder KrigingFuns in the current folder
% SURROGATES   1 x T struct array of fitSurrogate
%
% Each model is kept as a function that users can call, <folder>/<name>.m, and
% as text that evaluateKriging reads when it is given the names; it takes the
% surrogates much faster. Models of files are fitted as published: the noise is
% estimated, stk_param_init, stk_param_estim, no prior.
%
% Errors: DEcalioc:createKrigingModels:missingFile, :badShape, :unknownName
%
% See also: fitSurrogates, evaluateKriging

function [names, folder, surrogates] = createKrigingModels ...
  (ExPlanFiles, RespFiles, ParamLims, trend, covariance)
  %| pragma Justify (metric, "parameters", "the call is published");
  if isstruct (ExPlanFiles)
    surrogates = ExPlanFiles;
    if nargin > 1
      surrogates = fitSurrogates (ExPlanFiles, RespFiles);
    end
    files = {surrogates.name};
  else
    options = struct ('trend', 'affine', 'covariance', 'matern', ...
                      'published', true);
    if nargin > 3 && ~isempty (trend)
      options.trend = trendOf (trend);
    end
    if nargin > 4 && ~isempty (covariance)
      options.covariance = covarianceOf (covariance);
    end
    files = unfold (RespFiles);
    surrogates = ofTables (ExPlanFiles, files, ParamLims, options);
  end
  folder = 'KrigingFuns';
  names = [saveSurrogates(surrogates, folder)', files(:)];
end

function name = trendOf (trend)
  known = {'affine', 'quadratic', 'constant'};
  k = find (strcmp (trend, strcat ('stk_lm_', known)));
  if isnumeric (trend)
    k = find (trend == [1, 2]);
  end
  if numel (k) ~= 1
    refuse ('TREND', trend, ['1, 2, stk_lm_constant, stk_lm_affine or ' ...
                             'stk_lm_quadratic']);
  end
  name = known{k};
end

function name = covarianceOf (covariance)
  parts = {{}};
  if ischar (covariance)
    parts = regexp (covariance, ['^stk_(?:(matern)cov(32|52)?|(gauss|exp|sph)' ...
                                 'cov)(_iso|_aniso)$'], 'tokens');
  end
  if isempty (parts) || isempty (parts{1})
    refuse ('COVARIANCE', covariance, ['the name of a covariance of stk, ' ...
                                       'as stk_materncov_aniso']);
  end
  name = strrep ([parts{1}{:}], '_aniso', '');
end

function refuse (argument, given, expected)
  error ('DEcalioc:createKrigingModels:unknownName', ...
         'createKrigingModels: %s must be %s, got %s.', argument, expected, ...
         describeValue (given));
end

function surrogates = ofTables (plans, responses, limits, options)
  plans = cellstr (plans);
  for t = 1:numel (responses)
    X = readTable (plans{min(t, numel (plans))});
    z = readTable (responses{t});
    if rows (X) ~= rows (z)
      error ('DEcalioc:createKrigingModels:badShape', ...
             ['createKrigingModels: %s must have one row per plan row, ' ...
              'got %d for %d.'], responses{t}, rows (z), rows (X));
    end
    options.name = sprintf ('KM_fun_%d', t);
    surrogates(t) = fitSurrogate (X, z(:, 1), limits, options);
  end
end

function list = unfold (files)
  list = {};
  if ischar (files)
    files = cellstr (files);
  end
  for i = 1:numel (files)
    if iscell (files{i})
      list = [list, unfold(files{i})];
    else
      list = [list, files(i)];
    end
  end
end

function M = readTable (file)
  if ~exist (file, 'file')
    error ('DEcalioc:createKrigingModels:missingFile', ...
           'createKrigingModels: %s must be a CSV file, it is missing.', ...
           file);
  end
  text = readText (file);
  first = strtok (text, "\n");
  skip = double (any (isletter (regexprep (first, 'NaN|Inf|[eE]', ''))));
  M = dlmread (file, ',', skip, 0, 'emptyvalue', NaN);
end

%!shared X
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (14, 2);

%!function inFolder (f)
%!  back = onCleanup (@() cd (pwd ()));
%!  folder = tempname ();
%!  mkdir (folder);
%!  cd (folder);
%!  f ();
%!  confirm_recursive_rmdir (false, 'local');
%!  cd (fileparts (folder));
%!  rmdir (folder, 's');
%!endfunction

%!function text = refusal (f)
%!  text = '';
%!  try
%!    f ();
%!  catch err
%!    text = err.message;
%!  end
%!endfunction

%!function published (X)
%!  csvwrite ('plan.csv', X);
%!  csvwrite ('a.csv', X * [1; 2]);
%!  csvwrite ('b.csv', setfield (X * [3; -1], {2}, NaN));
%!  [names, folder, s] = createKrigingModels ('plan.csv', ...
%!                         {'a.csv', {'b.csv'}}, [0, 0; 1, 1]);
%!  assert (folder, 'KrigingFuns');
%!  assert (names, {'KM_fun_1', 'a.csv'; 'KM_fun_2', 'b.csv'});
%!  r = evaluateKriging ([0.5; 0.5], names);
%!  assert (r, [1.5; 1], 0.02);
%!  assert (evaluateKriging ([0.5; 0.5], {s}), r, 1e-6);
%!  assert ({s.trend, s.covariance}, {'affine', 'affine', 'matern', 'matern'});
%!  assert (numel (s(2).z), 13);
%!  call = {'plan.csv', {'a.csv'}, [0, 0; 1, 1]};
%!  [~, ~, named] = createKrigingModels (call{:}, 'stk_lm_affine', ...
%!                                       'stk_materncov_aniso');
%!  [~, ~, early] = createKrigingModels (call{:}, 1);
%!  assert (named.theta, s(1).theta);
%!  assert (early.theta, s(1).theta);
%!  [~, ~, early] = createKrigingModels (call{:}, 2, 'stk_gausscov_iso');
%!  assert ({early.trend, early.covariance}, {'quadratic', 'gauss_iso'});
%!  assert (predictSurrogate (early, [0.5, 0.5]), 1.5, 0.02);
%!  refused = {{3}, {'affine'}, {1, 'matern52'}, {1, 5}};
%!  for k = 1:4
%!    said = refusal (@() createKrigingModels (call{:}, refused{k}{:}));
%!    assert (~isempty (regexp (said, 'must be .*, got', 'once')));
%!  end
%!endfunction
%!test
%! inFolder (@() published (X));

%!function likeStk (X)
%!  z = sin (4 * X(:, 1)) + X(:, 2).^2 + 0.05 * cos (40 * X(:, 1));
%!  csvwrite ('plan.csv', X);
%!  csvwrite ('z.csv', z);
%!  [~, ~, s] = createKrigingModels ('plan.csv', 'z.csv', [0, 0; 1, 1]);
%!  model = stk_model ('stk_materncov_aniso', 2);
%!  model.lm = stk_lm_affine ();
%!  model.lognoisevariance = NaN;
%!  [start, noise] = stk_param_init (model, X, z);
%!  [model.param, model.lognoisevariance] = ...
%!    stk_param_estim (model, X, z, start, noise);
%!  P = [0.3, 0.4; 0.8, 0.7];
%!  there = stk_predict (model, X, z, P);
%!  assert (predictSurrogate (s, P), there.mean, 0.01);
%!endfunction
%!test
%! % what the published calls of stk give
%! inFolder (@() likeStk (X));

%!function ofData (X)
%!  Case = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1]);
%!  Case.targets = struct ('name', 'mass', 'value', 1, 'tol', 0.01, 'sd', 0, ...
%!                         'role', 'calibrate', 'model', 1);
%!  Case.options = struct ();
%!  data = addRows (newData (2, 1), X, X * [1; 2], ones (14, 1), 'plan');
%!  [names, ~, s] = createKrigingModels (data, newProblem (Case, []));
%!  assert (names, {'KM_fun_1', 'mass'});
%!  assert (evaluateKriging ([0.5, 0.5], names), 1.5, 1e-3);
%!endfunction
%!test
%! % the runs of a calibration
%! inFolder (@() ofData (X));

%!function named ()
%!  writeAtomic ('named.csv', "a,b\n0,0\n1,0\n0,1\n1,1\n0.5,0.4\n");
%!  writeAtomic ('z.csv', "0\n1\n2\n3\n1.3\n");
%!  [~, ~, s] = createKrigingModels ('named.csv', {'z.csv'}, [0, 0; 1, 1]);
%!  assert (predictSurrogate (s, [0.2, 0.3]), 0.8, 0.01);
%!  writeAtomic ('z.csv', "0\n1\n2\n3\n");
%!  said = refusal (@() createKrigingModels ('named.csv', {'z.csv'}, ...
%!                                           [0, 0; 1, 1]));
%!  assert (~isempty (strfind (said, 'one row per plan row, got 4 for 5')));
%!endfunction
%!test
%! % with names in the first line; a response of another length
%! inFolder (@named);

%!error id=DEcalioc:createKrigingModels:missingFile
%! createKrigingModels ('no such plan.csv', {'x.csv'}, [0; 1]);

% SPDX-License-Identifier: GPL-3.0-only
