% CREATEKRIGINGMODELS  One Kriging model per response, kept as data.
%
% CALL: [NAMES, FOLDER, SURROGATES] = createKrigingModels (EXPLANFILES,
%         RESPFILES, PARAMLIMS, TREND, COVARIANCE)
%       [NAMES, FOLDER, SURROGATES] = createKrigingModels (DATA, PROBLEM)
%
% EXPLANFILES  text or cellstr: CSV of the plan (n x d), one for all responses
%              or one per response
% RESPFILES    cellstr: CSV of one response each (n rows, NaN: failed); a cell
%              of cells (one per model) is unfolded
% PARAMLIMS    2 x d  limits of the design variables
% TREND        'constant', 'affine', 'quadratic' or 'choose' ('affine')
% COVARIANCE   'matern32', 'matern52', 'gauss' or 'choose' ('matern52');
%              anisotropic, noise estimated
% DATA         struct of newData: the finished runs, replicates among them
% PROBLEM      struct of newProblem; trend and covariance are chosen
% NAMES        1 x T cellstr 'KM_fun_1' ...
% FOLDER       text, the folder KrigingFuns in the current folder
% SURROGATES   1 x T struct array of fitSurrogate
%
% Each model is kept as a function that users can call, <folder>/<name>.m, and
% as text that evaluateKriging reads when it is given the names; it takes the
% surrogates much faster.
%
% Errors: DEcalioc:createKrigingModels:missingFile, :badShape
%
% See also: fitSurrogates, evaluateKriging

function [names, folder, surrogates] = createKrigingModels ...
  (ExPlanFiles, RespFiles, ParamLims, trend, covariance)
  %| pragma Justify (metric, "parameters", "the call is published");
  if isstruct (ExPlanFiles)
    surrogates = fitSurrogates (ExPlanFiles, RespFiles);
  else
    options = struct ('trend', 'affine', 'covariance', 'matern52');
    if nargin > 3 && ~isempty (trend)
      options.trend = trend;
    end
    if nargin > 4 && ~isempty (covariance)
      options.covariance = covariance;
    end
    surrogates = ofTables (ExPlanFiles, RespFiles, ParamLims, options);
  end
  folder = 'KrigingFuns';
  names = saveSurrogates (surrogates, folder);
end

function surrogates = ofTables (plans, responses, limits, options)
  plans = cellstr (plans);
  responses = unfold (responses);
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

%!shared here, tmp
%! pkg load stk
%! here = pwd ();
%! tmp = emptyFolder ();

%!test
%! clean = onCleanup (@() cd (here));
%! cd (tmp);
%! rand ('twister', 1);
%! X = rand (12, 2);
%! csvwrite ('plan.csv', X);
%! csvwrite ('a.csv', X * [1; 2]);
%! z = X * [3; -1];
%! z(2) = NaN;
%! csvwrite ('b.csv', z);
%! [names, folder, s] = createKrigingModels ('plan.csv', ...
%!                        {'a.csv', {'b.csv'}}, [0, 0; 1, 1]);
%! assert (names, {'KM_fun_1', 'KM_fun_2'});
%! r = evaluateKriging ([0.5; 0.5], names);
%! assert (r, [1.5; 1], 0.02);
%! assert (evaluateKriging ([0.5; 0.5], {s}), r, 1e-6);
%! assert ({s.trend}, {'affine', 'affine'});
%! assert (numel (s(2).z), 11);

%!test
%! % the runs of a calibration
%! clean = onCleanup (@() cd (here));
%! cd (tmp);
%! rand ('twister', 1);
%! X = rand (12, 2);
%! data = addRows (newData (2, 1), X, X * [1; 2], ones (12, 1), 'plan');
%! [names, ~, s] = createKrigingModels (data, smallProblem (1, 0.01, 2));
%! assert (evaluateKriging ([0.5, 0.5], names), 1.5, 1e-3);
%! assert (s.name, 'target_1');

%!test
%! % with names in the first line; a response of another length
%! clean = onCleanup (@() cd (here));
%! cd (tmp);
%! writeAtomic ('named.csv', "a,b\n0,0\n1,0\n0,1\n1,1\n0.5,0.4\n");
%! writeAtomic ('z.csv', "0\n1\n2\n3\n1.3\n");
%! [~, ~, s] = createKrigingModels ('named.csv', {'z.csv'}, [0, 0; 1, 1]);
%! assert (predictSurrogate (s, [0.2, 0.3]), 0.8, 0.01);
%! writeAtomic ('z.csv', "0\n1\n2\n3\n");
%! fail ('createKrigingModels (''named.csv'', {''z.csv''}, [0, 0; 1, 1])', ...
%!       'one row per plan row, got 4 for 5');

%!error id=DEcalioc:createKrigingModels:missingFile
%! createKrigingModels ('no such plan.csv', {'x.csv'}, [0; 1]);
