% EVALUATEKRIGING  The responses of one parameter set on the Kriging models.
%
% CALL: RESULT = evaluateKriging (PARAMS, SURROGATES)
% CALL: RESULT = evaluateKriging (PARAMS, NAMES)
%
% PARAMS      d x 1 or 1 x d  parameter set
% SURROGATES  1 x T struct array of createKrigingModels (fast)
% NAMES       cellstr of createKrigingModels, T x 2 or its first column: the
%             models are read from the folder KrigingFuns in the current folder
%             (slow)
%             Either may stand in a cell, as the published costFunction passes
%             its varargin on
% RESULT      T x 1  means of the responses
%
% Errors: DEcalioc:evaluateKriging:badType
%
% See also: evaluateDEM, createKrigingModels, predictSurrogate

function result = evaluateKriging (params, varargin)
  models = varargin;
  while iscell (models) && isscalar (models) && ~ischar (models{1})
    models = models{1};
  end
  if iscellstr (models) && ~isempty (models)
    if columns (models) == 2 && ~strncmp (models{1, 2}, 'KM_fun_', 7)
      models = models(:, 1);               % beside each the file of its responses
    end
    for t = numel (models):-1:1
      loaded(t) = loadSurrogate (fullfile ('KrigingFuns', ...
                                           [models{t}, '.txt']));
    end
    models = loaded;
  end
  if ~isstruct (models)
    error ('DEcalioc:evaluateKriging:badType', ...
           ['evaluateKriging: the second argument must be surrogates or ' ...
            'their names, got %s.'], class (models));
  end
  result = predictSurrogate (models, params(:)')';
end

%!test
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (10, 2);
%! s = fitSurrogate (X, X * [1; 2], [0, 0; 1, 1]);
%! r = evaluateKriging ([0.2; 0.4], {{[s, s]}});
%! assert (r, [1; 1], 0.02);
%! assert (evaluateKriging ([0.2, 0.4], [s, s]), r);

%!error id=DEcalioc:evaluateKriging:badType evaluateKriging (1, 2);

% SPDX-License-Identifier: GPL-3.0-only
