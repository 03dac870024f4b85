% OWNCOST  Finds the cost function of the case, or of the toolbox.
%
% CALL: COST = ownCost ()
%
% COST  handle of costFunction.m, the file of the case folder (the current one)
%       or else of the toolbox, see newProblem
%
% The file is parsed, not run.
%
% Errors: DEcalioc:ownCost:brokenCost

function cost = ownCost ()
  file = file_in_loadpath ('costFunction.m');
  clear ('-functions', 'costFunction');    % as in readInput
  try
    cost = @costFunction;
    if ~isempty (file)                   % who calls it hears that it is missing
      nargin (cost);
    end
  catch err
    error ('DEcalioc:ownCost:brokenCost', ...
           ['ownCost: %s must be a function residual = costFunction ' ...
            '(params, evaluateFunc, varargin), but reading it gave: %s'], ...
           file, strtrim (err.message));
  end
end

%!assert (nargin (ownCost ()), -3)
%!test
%! % a broken one stops the check of a case, and says where
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! file = fullfile (raw.folder, 'costFunction.m');
%! writeAtomic (file, "function r = costFunction (p, f)\nr = [1, ;\nend\n");
%! for name = {'check', 'status'}
%!   [status, text] = startCommand (raw.folder, name{1});
%!   assert (status, 1);
%!   for words = {[file, ' must be a function'], 'parse error near line'}
%!     assert (! isempty (strfind (text, words{1})), text);
%!   end
%! end
%! here = cd (raw.folder);
%! back = onCleanup (@() cd (here));
%! clear costFunction
%! fail ('ownCost ()', 'must be a function');
%! clear back costFunction
%!error id=DEcalioc:ownCost:brokenCost
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'costFunction.m'), 'function r = (');
%! here = cd (folder);
%! back = onCleanup (@() cd (here));
%! clear costFunction
%! ownCost ();

% SPDX-License-Identifier: GPL-3.0-only
