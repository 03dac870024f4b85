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
% Errors: those of fitTables
%
% See also: fitTables, fitSurrogates, evaluateKriging

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
    surrogates = fitTables (ExPlanFiles, RespFiles, ParamLims, options);
  end
  folder = 'KrigingFuns';
  names = saveSurrogates (surrogates, folder);
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

%!test
%! % the runs of a calibration
%! clean = onCleanup (@() cd (here));
%! cd (tmp);
%! C = struct ('names', {{'a', 'b'}}, 'limits', [0, 0; 1, 1], ...
%!             'targets', struct ('value', 1, 'tol', 0.01));
%! rand ('twister', 1);
%! X = rand (12, 2);
%! data = addRows (newData (2, 1), X, X * [1; 2], ones (12, 1), 'plan');
%! [names, ~, s] = createKrigingModels (data, newProblem (C, []));
%! assert (evaluateKriging ([0.5, 0.5], names), 1.5, 1e-3);
%! assert (s.name, 'target_1');

%!error id=DEcalioc:fitTables:missingFile
%! createKrigingModels ('no such plan.csv', {'x.csv'}, [0; 1]);

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (tmp, 's');
