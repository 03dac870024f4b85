% CREATEKRIGINGMODELS  One Kriging model a response file, kept as data.
%
% CALL: [names, folder, surrogates] = createKrigingModels (ExPlanFiles,
%         RespFiles, ParamLims, trend, covariance)
%
% ExPlanFiles  char or cellstr: CSV of the plan (n x d), one for all responses
%              or one a response
% RespFiles    cellstr: CSV of one response each (n rows, NaN: failed); a cell
%              of cells (one a model) is unfolded
% ParamLims    2 x d  limits of the design variables
% trend        'constant', 'affine', 'quadratic' or 'choose' ('affine')
% covariance   'matern32', 'matern52', 'gauss' or 'choose' ('matern52');
%              anisotropic, noise estimated
% names        1 x T cellstr 'KM_fun_1' ...
% folder       char, the folder KrigingFuns in the current folder
% surrogates   1 x T struct array of fitSurrogate
%
% Each model is kept as <folder>/<name>.txt (text): the runs and the estimated
% parameters, no program. evaluateKriging takes the names or, much faster, the
% surrogates.
%
% Errors: DEcalioc:createKrigingModels:missingFile, :badShape
%
% See also: fitSurrogate, evaluateKriging, saveSurrogate

function [names, folder, surrogates] = createKrigingModels ...
  (ExPlanFiles, RespFiles, ParamLims, trend, covariance)
  %| pragma Justify (metric, "parameters", "the call is published");
  options = struct ('trend', 'affine', 'covariance', 'matern52');
  if nargin > 3 && ~isempty (trend)
    options.trend = trend;
  end
  if nargin > 4 && ~isempty (covariance)
    options.covariance = covariance;
  end
  plans = cellstr (ExPlanFiles);
  responses = unfold (RespFiles);
  folder = 'KrigingFuns';
  names = cell (1, numel (responses));
  for t = 1:numel (responses)
    which = min (t, numel (plans));
    X = readTable (plans{which});
    z = readTable (responses{t});
    names{t} = sprintf ('KM_fun_%d', t);
    options.name = names{t};
    if rows (X) ~= rows (z)
      error ('DEcalioc:createKrigingModels:badShape', ...
             ['createKrigingModels: %s must have one row a plan row, got ' ...
              '%d for %d.'], responses{t}, rows (z), rows (X));
    end
    surrogates(t) = fitSurrogate (X, z(:, 1), ParamLims, options);
    if ~isfolder (folder)
      mkdir (folder);
    end
    saveSurrogate (fullfile (folder, [names{t}, '.txt']), surrogates(t));
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
           'createKrigingModels: %s must be a CSV file, it is missing.', file);
  end
  text = fileread (file);
  first = strtok (text, "\n");
  skip = double (any (isletter (regexprep (first, 'NaN|Inf|[eE]', ''))));
  M = dlmread (file, ',', skip, 0, 'emptyvalue', NaN);
end

%!shared here, tmp
%! pkg load stk
%! here = pwd ();
%! tmp = tempname ();
%! mkdir (tmp);

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

%!error id=DEcalioc:createKrigingModels:missingFile
%! createKrigingModels ('no such plan.csv', {'x.csv'}, [0; 1]);

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (tmp, 's');
