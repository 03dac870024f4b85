% Every bad input is found before anything is run, under its own identifier.

%!function removeCase (folder)
%!  confirm_recursive_rmdir (false, 'local');
%!  [~, ~] = rmdir (folder, 's');
%!endfunction

%!function text = faultOf (row, k, good)
%!  % '' where the bad input is found as it should be, else what is wrong
%!  if isempty (row{2})
%!    good = goodInput (tempname ());
%!  end
%!  folder = good.folder;
%!  raw = spoil (good, row{2}, row{3});
%!  p = checkCase (raw, modeOf (row, k));
%!  text = '';
%!  mention = row{4};
%!  if isempty (mention)
%!    mention = row{2};
%!  end
%!  if isempty (p)
%!    text = 'no problem found';
%!  elseif ! strcmp (p(1).id, ['DEcalioc:checkCase:', row{1}])
%!    text = [p(1).id, ' first'];
%!  elseif ! all (cellfun (@(t) any (strfind (p(1).message, t)), ...
%!                         {mention, 'expected ', ', got ', '. '}))
%!    text = ['message does not say enough: ', p(1).message];
%!  elseif isfolder (fullfile (folder, 'store')) ...
%!      || isfolder (fullfile (folder, 'optim')) ...
%!      || isfile (fullfile (folder, 'RAN'))
%!    text = 'something was run';
%!  elseif mod (k, 40) == 0 || strcmp (getenv ('DECALIOC_SOAK'), '1')
%!    text = faultOfError (raw, p);
%!  end
%!  if isempty (row{2})
%!    removeCase (folder);
%!  end
%!endfunction

%!function mode = modeOf (row, k)
%!  % most need no other program, and are faster without
%!  mode = 'noPrograms';
%!  inFull = {'targetCount', 'ambiguousTargets', 'brokenGetResults', ...
%!            'resultWithoutRun', 'leftoverOutput', ...
%!            'badRunscript', 'storeUmask', 'storeNotWritable', 'folderNotWritable', ...
%!            'badStore', 'badFolder', 'diskSpace'};
%!  if any (strcmp (row{1}, inFull)) || mod (k, 40) == 0 ...
%!      || strcmp (getenv ('DECALIOC_SOAK'), '1')
%!    mode = 'full';
%!  end
%!endfunction

%!function text = faultOfError (raw, p)
%!  % newCase throws all of them under the identifier of the first
%!  text = 'newCase does not throw';
%!  try
%!    newCase (raw);
%!  catch err
%!    text = '';
%!    if ! strcmp (err.identifier, p(1).id)
%!      text = ['newCase throws ', err.identifier];
%!    elseif ! all (cellfun (@(m) any (strfind (err.message, m)), ...
%!                           {p.message}))
%!      text = 'newCase does not list all';
%!    end
%!  end
%!endfunction

%!test
%! bad = badInputs ();
%! good = goodInput (tempname ());
%! faults = '';
%! for k = 1:rows (bad)
%!   text = faultOf (bad(k, :), k, good);
%!   if ! isempty (text)
%!     faults = [faults, sprintf("%s %s: %s\n", bad{k, [1, 2]}, text)];
%!   end
%! end
%! removeCase (good.folder);
%! assert (faults, '');

%!test
%! % candidate effects: found by withEffects
%! bad = badEffects ();
%! good = goodInput (tempname ());
%! Case = newCase (good);
%! faults = '';
%! for k = 1:rows (bad)
%!   raw = spoil (good, bad{k, 2}, bad{k, 3});
%!   mention = bad{k, 4 - 2 * isempty (bad{k, 4})};
%!   said = '';
%!   try
%!     withEffects (Case, raw.effects);
%!   catch err
%!     said = [err.identifier, ' ', err.message];
%!   end
%!   wanted = {['DEcalioc:checkCase:', bad{k, 1}, ' '], mention, ...
%!             'expected ', ', got ', '. '};
%!   if ! all (cellfun (@(t) any (strfind (said, t)), wanted))
%!     faults = [faults, sprintf("%s %s: %s\n", bad{k, [1, 2]}, said)];
%!   end
%! end
%! removeCase (good.folder);
%! assert (faults, '');

%!test
%! for make = {@goodInput, @goodPublished}
%!   folder = tempname ();
%!   raw = make{1} (folder);
%!   p = checkCase (raw);
%!   assert (isempty (p), strjoin ([{p.message}, {''}], "\n"));
%!   assert (! isfile (fullfile (folder, 'RAN')));
%!   assert (! isfolder (fullfile (folder, 'optim')));
%!   removeCase (folder);
%! end

% SPDX-License-Identifier: GPL-3.0-only
