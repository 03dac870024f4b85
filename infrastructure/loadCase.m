% LOADCASE  Loads the user's case from a folder.
%
% CALL: CASE = loadCase (ROOT, FOLDER)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder, looked in before the toolbox (text)
%   CASE    scalar struct, see newCase
%
% Calls the user's loadInput.m (five outputs, as published). The candidate
% effects of the diagnosis are added by withEffects.
%
% Errors: DEcalioc:loadCase:missingFile    no loadInput.m
%         DEcalioc:loadCase:brokenInput    loadInput.m cannot be run
%         those of checkCase
%
% See also: newCase, checkCase, withEffects

function Case = loadCase (root, folder)
  raw = struct ('root', root, 'folder', folder, 'effects', []);
  if isempty (which ('loadInput'))
    error ('DEcalioc:loadCase:missingFile', ...
           ['loadCase: a file loadInput.m is expected in %s or %s. Copy ' ...
            'the one of the toolbox and edit it.'], folder, root);
  end
  try
    [raw.Input, raw.optim, raw.modelVars, raw.assign, raw.paramLims] = ...
      loadInput ();
  catch err
    error ('DEcalioc:loadCase:brokenInput', ...
           ['loadCase: %s must return [Input, optim, modelVars, assign, ' ...
            'paramLims], but running it gave: %s'], ...
           which ('loadInput'), whereAndWhat (err));
  end
  Case = newCase (raw);
end

function text = whereAndWhat (err)
  text = err.message;
  if ~isempty (err.stack)
    text = sprintf ('%s (%s, line %d)', text, err.stack(1).name, ...
                    err.stack(1).line);
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! fid = fopen (fullfile (folder, 'loadInput.m'), 'w');
%! fputs (fid, 'function [a, b, c, d, e] = loadInput (), a = nope; end');
%! fclose (fid);
%! addpath (folder);
%! unwind_protect
%!   try
%!     loadCase (folder, folder);
%!   catch err
%!   end
%!   assert (err.identifier, 'DEcalioc:loadCase:brokenInput');
%!   assert (! isempty (strfind (err.message, 'nope')));
%! unwind_protect_cleanup
%!   rmpath (folder);
%!   confirm_recursive_rmdir (false, 'local');
%!   rmdir (folder, 's');
%! end_unwind_protect
