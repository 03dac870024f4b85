% Full disk and cut power: each writer says so and leaves the old file whole.

%!function free = smallDisk (folder, kB)
%!  mkdir (folder);
%!  assert (system (sprintf ('mount -t tmpfs -o size=%dk tmpfs %s', kB, ...
%!                           folder)), 0);
%!  free = onCleanup (@() system (sprintf ('umount -l %s', folder)));
%!endfunction
%!function fill (folder)
%!  system (sprintf ('dd if=/dev/zero of=%s/ballast bs=1k 2> /dev/null', ...
%!                   folder));
%!endfunction
%!function data = someRuns (n)
%!  data.X = [(1:n)', ones(n, 1)];
%!  data.E = zeros (n, 0);
%!  data.Z = repmat ([1 / 3, 2 / 3, pi], n, 1);
%!  data.replicate = ones (n, 1);
%!endfunction
%!function s = surrogateOf (n)
%!  x = (1:n)' / n;
%!  s = fitSurrogate (x, x.^2, [0; 1], struct ());
%!endfunction

%!function yes = mayMount ()
%!  [status, ~] = system ('mkfs.ext4 -V 2>&1 && losetup -f 2>&1');
%!  yes = geteuid () == 0 && status == 0;
%!endfunction
%!function free = mounted (image, folder, options)
%!  [~, ~] = mkdir (folder);
%!  assert (system (sprintf ('mount -o loop%s %s %s', options, image, ...
%!                           folder)), 0);
%!  free = onCleanup (@() system (sprintf ('umount -l %s', folder)));
%!endfunction

%!testif ; geteuid () == 0 && system ('unshare -m true 2> /dev/null') == 0
%! % a disk that is full: an error, the old file is as it was, no draft is left
%! pkg load stk
%! Case = newCase (standInCase (tempname ()));
%! long = repmat ('x', 1, 1e5);
%! writers = { ...
%!   @(f, k) writeAtomic(f, long(1:k)), ...
%!   @(f, k) writeAtomic(f, long(1:k * 1e4)), ...
%!   @(f, k) writeMatrix(f, ones (k * 1000, 3)), ...
%!   @(f, k) writeRecord(f, struct ('message', long(1:k * 1e4))), ...
%!   @(f, k) exportRuns(f, Case, someRuns (k * 100)), ...
%!   @(f, k) saveSurrogate(f, surrogateOf (k * 50)), ...
%!   @(f, k) writeStl(f, rand (3, 3, 50 * k))};
%! for k = 1:numel (writers)
%!   folder = tempname ();
%!   free = smallDisk (folder, 1024);
%!   file = fullfile (folder, 'kept');
%!   writers{k}(file, 1);
%!   old = fileread (file);
%!   fill (folder);
%!   caught = '';
%!   try
%!     writers{k}(file, 4);
%!   catch err
%!     caught = err.identifier;
%!   end
%!   what = func2str (writers{k});
%!   assert (strcmp (caught, 'DEcalioc:writeAtomic:cannotWrite'), what);
%!   assert (strcmp (fileread (file), old), what);
%!   assert (isequal (sort (readdir (folder))', ...
%!                    {'.', '..', 'ballast', 'kept'}), what);
%!   clear free
%! end

%!testif ; geteuid () == 0 && system ('unshare -m true 2> /dev/null') == 0
%! % export of a case: the status says it, the old table stays
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, 'Input.numOfSam = 200;');
%! evaluateDEM ([1, 2; 3, 4; 5, 6; 7, 8], newCase (raw));
%! folder = tempname ();
%! free = smallDisk (folder, 64);
%! file = fullfile (folder, 'runs.csv');
%! writeAtomic (file, repmat ("whole\n", 1, 50));
%! fill (folder);
%! program = shellQuote (fullfile (raw.root, 'bin', 'decalioc'));
%! [status, out] = system (sprintf ('%s export %s %s 2>&1', program, ...
%!                                  raw.folder, file));
%! assert (status, 1);
%! assert (~isempty (strfind (out, 'disk may be full')), out);
%! assert (fileread (file), repmat ("whole\n", 1, 50));

%!testif ; geteuid () == 0 && system ('unshare -m true 2> /dev/null') == 0
%! % a run on a full disk: said, and no record of it is there
%! for early = [true, false]
%!   Case = newCase (standInCase (tempname ()));
%!   folder = tempname ();
%!   free = smallDisk (folder, 256);
%!   Case.store = folder;
%!   run = fullfile (Case.models(1).folder, 'runscript');
%!   if early
%!     fill (folder);
%!   else
%!     writeAtomic (run, ["dd if=/dev/zero of=big bs=1k 2> /dev/null\n", ...
%!                        fileread(run)]);
%!   end
%!   caught = '';
%!   try
%!     evaluateDEM ([1, 2], Case);
%!   catch err
%!     caught = err.message;
%!   end
%!   assert (~isempty (strfind (caught, 'Free some space')), caught);
%!   assert (isempty (glob (fullfile (folder, 'optim', 'First', '*', ...
%!                                    'record.json'))));
%!   clear free
%! end

%!testif ; mayMount ()
%! % power cut: what the disk has received at a moment is looked at after a new
%! % start. Names reach this disk a second after they are given, contents that
%! % nobody waits for half a minute later
%! work = tempname ();
%! mkdir (work);
%! disk = fullfile (work, 'disk');
%! image = @(k) fullfile (work, sprintf ('%d.img', k));
%! assert (system (sprintf ('truncate -s 40M %s && mkfs.ext4 -q %s', ...
%!                          image (0), image (0))), 0);
%! free = mounted (image (0), disk, ',noauto_da_alloc,commit=1');
%! file = fullfile (disk, 'file');
%! Case = newCase (standInCase (tempname ()));
%! Case.store = disk;
%! writeAtomic (file, repmat ('old', 1, 1000));
%! system (sprintf ('sync -f %s', disk));
%! writeAtomic (file, repmat ('new', 1, 1000));
%! writeAtomic (fullfile (disk, 'first'), repmat ('new', 1, 1000));
%! Z = evaluateDEM ([1, 2; 3, 4], Case);
%! for k = 1:2
%!   system (sprintf ('cp %s %s', image (0), image (k)));
%!   pause (2.5 * (k == 1));
%! end
%! clear free
%! for k = 1:2
%!   free = mounted (image (k), disk, '');
%!   assert (any (strcmp (fileread (file), {repmat('old', 1, 1000), ...
%!                                          repmat('new', 1, 1000)})));
%!   before = numel (listRunFolders (disk, 'First'));
%!   assert (evaluateDEM ([1, 2; 3, 4], Case), Z);
%!   made = numel (listRunFolders (disk, 'First')) - before;
%!   if k == 2                      % all names have got there: nothing is lost
%!     assert (fileread (file)(1:3), 'new');
%!     assert (fileread (fullfile (disk, 'first')), repmat ('new', 1, 1000));
%!     assert (made, 0);
%!   end
%!   clear free
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (work, 's');

%!test
%! % whatever Octave writes for others goes through writeAtomic, but for the
%! % log, which must not stop a calibration, saveWhole, which reads back, and
%! % caseId, whose file holds its own number
%! root = fileparts (which ('startToolbox'));
%! [~, found] = system (['cd ', shellQuote(root), ' && grep -rlE ', ...
%!   '"^[^%]*(fopen [(].*''[wa]''|[^_]save [(]|(csvwrite|dlmwrite) [(])" ', ...
%!   '--include="*.m" . | LC_ALL=C sort']);
%! assert (strsplit (strtrim (found), "\n"), ...
%!         {'./kit/files/writeAtomic.m', './report/sayLine.m', ...
%!          './runs/executors/saveWhole.m', './runs/table/caseId.m'});

% SPDX-License-Identifier: GPL-3.0-only
