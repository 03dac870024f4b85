% SITUATIONPAGE  The page data of a stored situation.
%
% CALL: PAGE = situationPage (NAME)
%
%   NAME  name of a situation, see verdictCase
%   PAGE  see pageData: no run, no surrogate
%
% See also: verdictCase

function page = situationPage (name)
  list = verdictCase ();
  raw = standInCase (tempname ());
  raw.optim.targetName = {{'sum', 'product'}, {'difference'}};
  verdictCase (raw.folder, list(strcmp ({list.name}, name)));
  page = pageData (newCase (raw));
  confirm_recursive_rmdir (false, 'local');
  rmdir (raw.folder, 's');
end

% SPDX-License-Identifier: GPL-3.0-only
