% MOVEASIDE  Starts a case afresh: moves what earlier starts have left aside.
%
% CALL: MOVED = moveAside (FOLDER)
%
%   FOLDER  case folder (text)
%   MOVED   cell of the new names; empty where there was nothing
%
% optim, results, KrigingFuns and gap get the present time appended to their
% names. Nothing is deleted, and moved back they count again.
%
% Errors: DEcalioc:moveAside:cannotWrite

function moved = moveAside (folder)
  moved = {};
  stamp = strftime ('-%Y-%m-%d-%H%M%S', localtime (time ()));
  for name = {'optim', 'results', 'KrigingFuns', 'gap'}
    old = fullfile (folder, name{1});
    if isfolder (old)
      [err, why] = rename (old, [old, stamp]);
      if err ~= 0
        error ('DEcalioc:moveAside:cannotWrite', ...
               'moveAside: %s must be movable, got: %s', old, why);
      end
      moved{end + 1} = [old, stamp];
    end
  end
end

%!test
%! folder = tempname ();
%! mkdir (fullfile (folder, 'optim'));
%! moved = moveAside (folder);
%! assert (numel (moved), 1);
%! assert (isfolder (moved{1}));
%! assert (! isfolder (fullfile (folder, 'optim')));
%! assert (isempty (moveAside (folder)));
