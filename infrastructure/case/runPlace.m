% RUNPLACE  Where the runs of a case lie, in its folder or in a shared store.
%
% CALL: PLACE = runPlace (CASE)                      of all models
%       PLACE = runPlace (CASE, MODEL)               of one
%       PLACE = runPlace (CASE, MODEL, RUN, ...)     a run, a file in it
%
%   CASE   see newCase (Input.store)
%   MODEL, RUN ...  names (text)
%   PLACE  path (text), there or not
%
% See also: sharesStore, listRunFolders

function place = runPlace (Case, varargin)
  place = fullfile (Case.store, 'optim', varargin{:});
end

%!test
%! Case.store = '/s';
%! assert (runPlace (Case), fullfile ('/s', 'optim'));
%! assert (runPlace (Case, 'M', '0001'), fullfile ('/s', 'optim', 'M', '0001'));

% SPDX-License-Identifier: GPL-3.0-only
